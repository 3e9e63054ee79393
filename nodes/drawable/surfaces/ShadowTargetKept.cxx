// The part of ShadowTarget that takes bits over from the mask before.
#include <array>
#include <cstddef>
#include <utility>

#include <vtkOpenGLState.h>
#include <vtkShaderProgram.h>

#include "Light.h"
#include "OpenGL.h"
#include "ShadowPrograms.h"
#include "ShadowTarget.h"

namespace shadow
{

bool ShadowTarget::attachMask(vtkOpenGLState* state, unsigned int texture)
{
  state->vtkglBindFramebuffer(GL_FRAMEBUFFER, this->framebuffer);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, this->getTextureTarget(), texture, 0);
  return glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

bool ShadowTarget::putMaskAside(vtkOpenGLState* state)
{
  if (this->maskBefore == 0)
  {
    this->maskBefore = this->makeMask(this->samplesAskedFor);
  }
  if (!this->attachMask(state, this->maskBefore))
  {
    this->attachMask(state, this->maskTexture);
    return false;
  }
  std::swap(this->maskTexture, this->maskBefore);
  return true;
}

bool ShadowTarget::takeOver(vtkOpenGLState* state, ShadowPrograms& programs, const KeptBits& kept,
                            bool reversedDepth)
{
  vtkShaderProgram* program =
      programs.use(this->samples > 1 ? ShadowPrograms::KeptSamples : ShadowPrograms::Kept, false);
  if (program == nullptr)
  {
    return false;
  }
  std::array<int, maximumLights> from{};
  std::array<int, maximumLights> to{};
  for (std::size_t i = 0; i < kept.moved.size(); ++i)
  {
    from[i] = kept.moved[i].first;
    to[i] = kept.moved[i].second;
  }
  program->SetUniformi("keptBits", static_cast<int>(kept.inPlace));
  program->SetUniformi("moves", static_cast<int>(kept.moved.size()));
  program->SetUniform1iv("movedFrom", maximumLights, from.data());
  program->SetUniform1iv("movedTo", maximumLights, to.data());
  state->vtkglDisable(GL_STENCIL_TEST);
  this->combineWithMask(state, program, this->maskBefore, "maskBefore", reversedDepth);
  return true;
}

} // namespace shadow
