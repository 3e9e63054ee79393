#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "FaceCounter.h"
#include "KeptBits.h"
#include "ScreenRectangle.h"

class vtkOpenGLRenderWindow;
class vtkOpenGLState;
class vtkShaderProgram;

namespace shadow
{

class ShadowPrograms;

/// The render target of the shadow stages: 32-bit float depth, the buffer that volumes are counted in, and
/// the shadow mask with one bit for each of 32 lights, all with the same number of samples.
class ShadowTarget
{
public:
  ShadowTarget() = default;
  ShadowTarget(const ShadowTarget&) = delete;
  ShadowTarget& operator=(const ShadowTarget&) = delete;

  /// Makes the target this large; does nothing when it is.
  /// @param buffer  not Auto
  /// @return false with a line in @p error when the GL refuses
  bool allocate(vtkOpenGLState* state, int width, int height, int samples, CountBuffer buffer,
                std::string& error);

  /// Binds the target, sets the viewport and clears: mask all reached, depth farthest, count 0.
  void begin(vtkOpenGLState* state, bool reversedDepth);

  /// Makes ready for counting faces with a FaceCounter, from zero.
  /// @param counted  faces are counted, and folded, in these pixels only
  void beginCount(vtkOpenGLState* state, const ScreenRectangle& counted);

  /// Where the count is not zero and there is a surface, takes the light's bit out of the mask.
  /// @pre   beginCount() called since the last fold
  /// @post  there is no scissor
  /// @return false when the shader does not compile
  bool foldCount(vtkOpenGLState* state, ShadowPrograms& programs, int light, bool reversedDepth);

  /// Puts the mask as it is aside for takeOver(), and another in its place. @pre allocate() has been called
  /// @return false when the GL refuses; the mask is then still there
  bool putMaskAside(vtkOpenGLState* state);

  /// Takes bits over from the mask that was put aside: what they do not reach is not reached.
  /// @pre   begin() called since putMaskAside(), and depth drawn; those bits face what they did
  /// @return false when the shader does not compile
  bool takeOver(vtkOpenGLState* state, ShadowPrograms& programs, const KeptBits& kept, bool reversedDepth);

  /// Draws a fragment, which is written nowhere, for each pixel where a bit of the mask is cleared.
  /// @pre   begin() called since the last beginCount(); volumes are counted in colour, one sample a pixel
  /// @return false when the shader does not compile
  bool drawWhereCleared(vtkOpenGLState* state, ShadowPrograms& programs, std::uint32_t bit);

  /// Copies the mask's bit of a light: width * height values, bottom row first; 255 reached, 0 shadowed,
  /// between for pixels whose samples differ.
  std::vector<unsigned char> readMask(vtkOpenGLRenderWindow* window, int light);

  /// Frees the GL objects. @pre their context is current, or is gone and @p contextLost
  void release(bool contextLost = false);

  unsigned int getMaskTexture() const { return this->maskTexture; }
  unsigned int getDepthTexture() const { return this->depthTexture; }
  unsigned int getTextureTarget() const; ///< GL_TEXTURE_2D or GL_TEXTURE_2D_MULTISAMPLE
  int getWidth() const { return this->width; }
  int getHeight() const { return this->height; }
  int getSamples() const { return this->samples; } ///< what the GL gave; may be more than was asked for
  /// Of each sample x and y in its pixel, 0 to 1.
  const std::vector<float>& getSamplePlaces() const { return this->samplePlaces; }
  std::size_t getMemorySize() const;               ///< bytes

private:
  void readResolved(vtkOpenGLRenderWindow* window, int light, std::vector<unsigned char>& mask);
  unsigned int makeTexture(unsigned int internalFormat, unsigned int format, unsigned int type) const;
  unsigned int makeMask(int samplesOfMask) const;
  bool attachMask(vtkOpenGLState* state, unsigned int texture);

  void findSamplePlaces(vtkOpenGLState* state);
  unsigned int makeFramebuffer(vtkOpenGLState* state, unsigned int colorTexture) const;
  void drawReading(vtkOpenGLState* state, unsigned int texture, vtkShaderProgram* program,
                   const char* sampler) const;
  void drawScreen() const;
  /// Draws a program over all surfaces, combined with the mask by logical AND.
  /// @param texture  that it reads; 0: none
  void combineWithMask(vtkOpenGLState* state, vtkShaderProgram* program, unsigned int texture,
                       const char* sampler, bool reversedDepth) const;

  CountBuffer buffer = CountBuffer::Stencil;
  unsigned int framebuffer = 0;      ///< mask and depth, with stencil
  unsigned int countFramebuffer = 0; ///< count and the same depth; the same as framebuffer for Stencil
  unsigned int maskTexture = 0;
  unsigned int maskBefore = 0; ///< 0 until a mask has been put aside
  unsigned int depthTexture = 0;
  unsigned int countTexture = 0; ///< Color only
  unsigned int emptyVertexArray = 0;
  int width = 0;
  int height = 0;
  int samples = 0;
  int samplesAskedFor = 0;
  std::vector<float> samplePlaces;
};

} // namespace shadow
