#pragma once

#include <string>

#include <glm/glm.hpp>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;

namespace shadow
{

/// The shader programs of the shadow stages, kept in the window's shader cache.
class ShadowPrograms
{
public:
  enum Stage
  {
    PrePass,
    VolumeInStencil, ///< see CountBuffer
    VolumeInColor,
    MaskFromStencil,
    MaskFromColor,
    MaskFromSamples, ///< the same with several samples a pixel
    Resolve,
    Facing ///< parallel does not matter
  };

  explicit ShadowPrograms(vtkOpenGLRenderWindow* renderWindow) : window(renderWindow) {}

  /// Makes the stage's program current. @return nullptr when it does not compile; VTK has then reported why
  vtkShaderProgram* use(Stage stage, bool parallel);

private:
  vtkOpenGLRenderWindow* window;
};

/// Hands a double matrix to the program as float, column-major.
void setUniform(vtkShaderProgram* program, const char* name, const glm::dmat4& matrix);
void setUniform(vtkShaderProgram* program, const char* name, const glm::dvec4& vector);

} // namespace shadow
