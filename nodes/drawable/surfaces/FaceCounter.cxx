#include "FaceCounter.h"

#include <vtkOpenGLState.h>
#include <vtkShaderProgram.h>

#include "OpenGL.h"
#include "ShadowVolume.h"

namespace shadow
{

std::size_t mostCountableIn(CountBuffer buffer)
{
  // Floats hold every whole number up to 2^24.
  return buffer == CountBuffer::Color ? std::size_t{1} << 24 : mostCountable;
}

FaceCounter::FaceCounter(const Target& countTarget, StencilCount count, bool isMirrored)
    : target(countTarget), stencilCount(count), mirrored(isMirrored)
{
  GLenum passes = this->target.reversedDepth ? GL_GREATER : GL_LESS;
  if (this->target.buffer == CountBuffer::Color && count == StencilCount::ZFail)
  {
    // Colour is written where the test passes, so that z-fail needs the opposite test.
    passes = this->target.reversedDepth ? GL_LEQUAL : GL_GEQUAL;
  }
  this->target.state->vtkglDepthFunc(passes);
}

// Faces whose outside is seen are entered, the others left, as the eye looks along the ray.
void FaceCounter::setUp(int multiplicity, bool inward) const
{
  const bool outsideIsFrontFace = this->mirrored == inward;
  const bool zPass = this->stencilCount == StencilCount::ZPass;
  if (this->target.buffer == CountBuffer::Color)
  {
    const float front = static_cast<float>(outsideIsFrontFace == zPass ? multiplicity : -multiplicity);
    const float weights[2] = {front, -front};
    this->target.program->SetUniform2f("faceWeights", weights);
    return;
  }
  const GLenum outside = outsideIsFrontFace ? GL_FRONT : GL_BACK;
  const GLenum inside = outsideIsFrontFace ? GL_BACK : GL_FRONT;
  if (zPass)
  {
    this->target.state->vtkglStencilOpSeparate(outside, GL_KEEP, GL_KEEP, GL_INCR_WRAP);
    this->target.state->vtkglStencilOpSeparate(inside, GL_KEEP, GL_KEEP, GL_DECR_WRAP);
  }
  else
  {
    this->target.state->vtkglStencilOpSeparate(outside, GL_KEEP, GL_DECR_WRAP, GL_KEEP);
    this->target.state->vtkglStencilOpSeparate(inside, GL_KEEP, GL_INCR_WRAP, GL_KEEP);
  }
}

} // namespace shadow
