#pragma once

#include <string>

#include <glm/glm.hpp>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;

namespace shadow
{

/// The shader programs of the shadow stages and of outlines, kept in the window's shader cache.
class ShadowPrograms
{
public:
  enum Stage
  {
    PrePass,
    VolumeInStencil, ///< see CountBuffer
    VolumeInColor,
    VolumeInColorHandedOn, ///< the same through a geometry shader, to go with VolumeOfTriangles
    MaskFromStencil,
    MaskFromColor,
    MaskFromSamples, ///< the same with several samples a pixel
    Kept,            ///< bits of the mask before
    KeptSamples,     ///< the same with several samples a pixel
    BackSeen,
    Resolve,
    AddLight,
    Facing, ///< parallel does not matter
    // Where the facing is known to the GPU only, see shaders/facingSource.glsl:
    SurfacePrePass,
    SurfaceCap,
    Sides,
    SurfacePrePassHandedOn, ///< SurfacePrePass through a geometry shader, to go with the next:
    VolumeOfTriangles,      ///< sides and caps, made in the geometry shader
    TriangleFacing,         ///< into a texture, as EdgeStates; parallel does not matter
    EdgeStates,
    // Of outlines; parallel does not matter:
    OutlineDepth,
    OutlineEdges, ///< LineTechnique::Rectangles
    OutlineFaces, ///< LineTechnique::Faces
    OutlineBlend
  };

  explicit ShadowPrograms(vtkOpenGLRenderWindow* renderWindow) : window(renderWindow) {}

  /// Makes the stage's program current.
  /// @param fromNear  what is drawn begins at the near plane, although depth clamp is on: surfaces of a
  ///                  parallel view, and volumes where startsAtNear() says so
  /// @param switches  lines of the preprocessor to put before it
  /// @return nullptr when it does not compile; VTK has then reported why
  vtkShaderProgram* use(Stage stage, bool fromNear, const std::string& switches = "");

private:
  vtkOpenGLRenderWindow* window;
};

/// What depth is multiplied with, and what times w is added, so that positions keep their depth, or that
/// sides of volumes lie a few units of rounding farther: where a side starts at the edge of a lit surface it
/// would else be a matter of rounding whether it is in front of that surface. That is how it is without
/// reversed depth (clip control, GL 4.5): there only what is up to three or four times as far as the near
/// plane is sure to be moved, for a shift that always counts would be seen elsewhere.
/// @post what is on the far plane stays there: the ends at infinity of volumes are not cut off
glm::vec2 depthBias(bool reversedDepth, bool asSides);

/// Has a program draw with that. @pre the program is current
/// @param uniform  its name in the program
void setDepthBias(vtkShaderProgram* program, bool reversedDepth, bool asSides,
                  const char* uniform = "depthBias");

/// Hands a double matrix to the program as float, column-major.
void setUniform(vtkShaderProgram* program, const char* name, const glm::dmat4& matrix);
void setUniform(vtkShaderProgram* program, const char* name, const glm::dvec4& vector);

/// The light of a volume as shaders/extrusion.glsl takes it, with twice the digits of a float.
struct LightValues
{
  glm::vec4 lightMC;
  glm::vec3 lightLowMC;
  float rayLength;
};

/// @param lightMC  relative to the geometry's origin; w = 1: position; w = 0: direction towards the light
/// @param reach    SEDGeometry::getReach()
LightValues makeLightValues(const glm::dvec4& lightMC, double reach);

/// Hands these to the program.
void setLight(vtkShaderProgram* program, const glm::dvec4& lightMC, double reach);

} // namespace shadow
