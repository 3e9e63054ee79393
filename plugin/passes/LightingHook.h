#ifndef LightingHook_h
#define LightingHook_h

#include <string>
#include <vector>

#include "ShadowVolumeEffect.h"
#include "View.h"

class vtkOpenGLState;
class vtkShaderProgram;

namespace shadow
{

/// Puts the shadow mask into the fragment shaders of VTK's own mappers: each light's diffuse and specular
/// part is multiplied by a shadow factor. See shaders/shadowFactor.glsl.
class LightingHook
{
public:
  /// Values of LightingHook::pass besides a light's index.
  enum Pass
  {
    AllLights = -1,
    AmbientOnly = -2
  };

  /// Changes a shader.
  ///
  /// @param mirrored  the prop's surfaces are in the mask; if not, the shader compares depths
  /// @return false when the shader has lights but none of the lines we know
  bool substitute(std::string& fragmentShader, bool mirrored) const;

  /// Binds mask and depth to texture units of their own. @post end() must be called
  void begin(vtkOpenGLState* state, ShadowVolumeEffect& effect, const View& view);
  void end(vtkOpenGLState* state);

  /// Hands the uniforms to a program.
  void setUniforms(vtkOpenGLState* state, vtkShaderProgram* program) const;

  std::vector<float> strength; ///< a light that is switched on: 0 no shadow, 1 all of its light
  int pass = AllLights;        ///< which light the coming pass draws
  int samples = 1;             ///< samples a pixel of the mask
  bool knowsCoverage = false;  ///< of the GL: shaders can ask which samples a fragment covers

private:
  /// A texture of ours in a unit that VTK has given.
  struct BoundTexture
  {
    int unit = -1;
    int before = 0; ///< what was bound there
  };
  BoundTexture bind(vtkOpenGLState* state, unsigned int texture) const;

  BoundTexture boundMask;
  BoundTexture boundDepth;
  unsigned int textureTarget = 0;
  const std::vector<float>* samplePlaces = nullptr; ///< of the mask, while it is bound
  float range[4] = {0.0f, 0.0f, 0.0f, 0.0f};
  bool reversed = true;
};

} // namespace shadow

#endif
