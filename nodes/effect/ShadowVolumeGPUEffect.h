#pragma once

#include <memory>
#include <string>
#include <vector>

#include "BruteForceSilhouette.h"
#include "GPUSilhouette.h"
#include "ShadowVolumeEffect.h"
#include "VETCollector.h"

namespace shadow
{

class FacingTexture;

/// The passes of ShadowVolumeEffect with the silhouette found on the GPU.
///
/// 1. SilhouetteCamera, or whatever the method does before it draws
/// 2. pre-pass, with the facing from there
/// 3. facing-texture: the texture read back, edges classified and extruded on the CPU while the GL works on
///    the pre-pass; else nothing
/// 4. for each light: volumes counted
///
/// Methods that keep everything on the GPU count in colour, since nothing there bounds how often a ray enters
/// a volume. Of lights very close to a triangle, or within rounding of its plane, volumes come from the CPU
/// with every method.
///
/// @par Source  Shi 2006, chapter 4.3
class ShadowVolumeGPUEffect : public ShadowVolumeEffect
{
public:
  explicit ShadowVolumeGPUEffect(SilhouetteMethod gpuMethod);

  SilhouetteMethod getMethod() const { return this->name; }

  CountBuffer chooseCountBuffer(CountBuffer wanted, int samples) const override;
  void release(bool contextLost) override;
  std::size_t getGraphicsMemorySize() const override;

protected:
  bool findFacing(const Frame& frame, std::string& error) override;
  bool drawSurfaces(const Frame& frame, std::string& error) override;
  bool findSilhouettes(const Frame& frame, std::string& error) override;
  bool drawVolumes(const Frame& frame, const Light& light, std::string& error) override;

private:
  bool drawExactVolumes(const Frame& frame, StencilCount count, std::string& error);

  SilhouetteMethod name;
  std::unique_ptr<GPUSilhouette> method;
  FacingTexture* readBack = nullptr;   ///< the method, when the CPU classifies the edges
  BruteForceSilhouette edgeClassifier; ///< for readBack
  VETCollector collector;
  std::vector<Light> lightsBefore; ///< of the frame before
  bool hasExactVolumes = false;    ///< of the coming frame; see ExactVolumeVisitor
  bool reading = false;            ///< the coming frame's facing is being read back
};

} // namespace shadow
