#include "CountableVolumes.h"

#include <cstddef>
#include <optional>
#include <utility>

namespace shadow
{

namespace
{

/// Triangles [first, last), which casts what the others leave out.
struct Range
{
  std::size_t first;
  std::size_t last;
};

FacingBits keepRange(const FacingBits& bits, const Range& range)
{
  FacingBits kept(bits.size());
  for (std::size_t triangle = range.first; triangle < range.last; ++triangle)
  {
    if (bits.test(triangle))
    {
      kept.set(triangle);
    }
  }
  return kept;
}

/// Divides a range until each part can be counted. A triangle that does not cast has neither bit, so a part
/// is a mesh of its own: its casting triangles, with borders where it was cut.
class VolumeDivider
{
public:
  VolumeDivider(const SEDGeometry& theGeometry, const SilhouetteFinder& theFinder,
                const LightFacing& theFacing, const glm::dvec4& theLightMC,
                const ShadowVolumeOptions& theOptions)
      : geometry(theGeometry), finder(theFinder), facing(theFacing), lightMC(theLightMC), options(theOptions)
  {
  }

  void divide(const Range& range, std::vector<ShadowVolume>& volumes) const
  {
    const LightFacing part = {keepRange(this->facing.towards, range), keepRange(this->facing.away, range)};
    const std::vector<SilhouetteEdge> silhouette =
        this->finder.find(this->geometry, part, Casting::EveryTriangle);
    ShadowVolume volume = extrudeSilhouette(this->geometry, silhouette, part, Casting::EveryTriangle,
                                            this->lightMC, this->options);
    if (volume.overlapBound <= this->options.countable || range.last - range.first <= this->options.countable)
    {
      if (volume.getTriangleCount() > 0)
      {
        volumes.push_back(std::move(volume));
      }
      return;
    }
    const std::size_t middle = range.first + (range.last - range.first) / 2;
    this->divide({range.first, middle}, volumes);
    this->divide({middle, range.last}, volumes);
  }

private:
  const SEDGeometry& geometry;
  const SilhouetteFinder& finder;
  const LightFacing& facing; ///< with the casting triangles' bits only
  const glm::dvec4& lightMC;
  const ShadowVolumeOptions& options;
};

} // namespace

std::vector<ShadowVolume> makeCountableVolumes(const SEDGeometry& geometry, const SilhouetteFinder& finder,
                                               const LightFacing& exactFacing, const glm::dvec4& lightMC,
                                               const ShadowVolumeOptions& options)
{
  const std::optional<LightFacing> simplified = finder.simplifyFacing(geometry, exactFacing);
  const LightFacing& facing = simplified ? *simplified : exactFacing;
  const Casting casting = chooseCasting(geometry, lightMC);
  const std::vector<SilhouetteEdge> silhouette = finder.find(geometry, facing, casting);
  std::vector<ShadowVolume> volumes;
  volumes.push_back(extrudeSilhouette(geometry, silhouette, facing, casting, lightMC, options));
  if (volumes.front().overlapBound <= options.countable)
  {
    return volumes;
  }
  volumes.clear();
  LightFacing castingOnly = facing;
  if (casting == Casting::LightFacing)
  {
    castingOnly.away.assign(facing.away.size());
  }
  const VolumeDivider divider(geometry, finder, castingOnly, lightMC, options);
  divider.divide({0, geometry.getTriangles().size()}, volumes);
  return volumes;
}

} // namespace shadow
