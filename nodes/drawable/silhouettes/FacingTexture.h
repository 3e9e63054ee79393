#pragma once

#include "EdgeQuadSilhouette.h"
#include "SilhouetteCamera.h"
#include "TriangleDrawable.h"

namespace shadow
{

/// The facing of all triangles of the scene for all lights in one texture, drawn by the SilhouetteCamera.
/// Volumes are drawn from there, or the texture is read back for the CPU to find the silhouette.
///
/// @par Source  Shi 2006, chapters 3.3 (improved method) and 4.3; that the texture may stay on the GPU is
/// ours
class FacingTexture : public EdgeQuadSilhouette
{
public:
  bool needsCollection() const override { return true; }
  bool begin(const Frame& theFrame, std::string& error) override;

  /// Whether begin() has drawn the texture, and not found it as it has to be.
  bool isNew() const { return this->drawnNow; }

  /// Asks for a copy of the texture in main memory.
  void startReadBack() { this->camera.startReadBack(this->getFrame().window); }

  /// Waits for the copy. @return false when there is none
  bool fetch() { return this->camera.fetch(); }

  /// The fetched facing of a geode on a path; left as it is for one that is not in the collection.
  /// @pre  fetch() has succeeded in this frame
  void getFacing(const NodePath& path, const Light& light, LightFacing& facing) const;

  const ReadBackTimes& getReadBackTimes() const { return this->camera.getReadBackTimes(); }

  void release(bool contextLost) override;
  std::size_t getMemorySize() const override;

protected:
  std::string getFacingSwitches() const override { return "#define SHADOW_FACING_TEXTURE\n"; }
  void bindFacing(vtkShaderProgram* program, const Surface& surface,
                  const std::vector<Light>& lights) override;

private:
  TriangleDrawable triangles;
  SilhouetteCamera camera;
  bool drawnNow = false;
};

} // namespace shadow
