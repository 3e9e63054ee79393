#pragma once

#include "GPUSilhouette.h"

namespace shadow
{

/// Each triangle comes with its neighbours, and the geometry shader makes the sides of its edges on the
/// silhouette and its caps.
///
/// @par Cost    O(triangles) a light and caster: the facing of each that casts and of its neighbours
/// @par Source  Zerari & Babahenini 2011, "Shadow Volume in Real-Time Rendering". They leave out open meshes,
///              and draw the caps from elsewhere
class GeometryShaderSilhouette : public GPUSilhouette
{
public:
  bool drawVolume(const Surface& surface, const Light& light, StencilCount count) override;

  ShadowPrograms::Stage getVolumeStage() const override;

protected:
  ShadowPrograms::Stage getSurfaceStage() const override;
};

} // namespace shadow
