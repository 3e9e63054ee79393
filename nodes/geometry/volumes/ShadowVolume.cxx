#include "ShadowVolume.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "CloseTriangles.h"
#include "OverlapBound.h"

namespace shadow
{

namespace
{

std::uint32_t nearCopy(std::uint32_t vertex)
{
  return 2 * vertex;
}

std::uint32_t farCopy(std::uint32_t vertex)
{
  return 2 * vertex + 1;
}

/// Extrudes for one light; holds what all parts of the volume need.
class Extruder
{
public:
  Extruder(const SEDGeometry& geometryIn, const LightFacing& facingIn, Casting castingIn,
           const glm::dvec4& lightMC, bool farAtInfinity, ShadowVolume::ClosePart& closePart)
      : geometry(geometryIn), facing(facingIn), casting(castingIn),
        farCopiesCoincide(lightMC.w == 0.0 && farAtInfinity),
        closeTriangles(findCloseTriangles(geometryIn, facingIn, castingIn, lightMC)),
        closeBuilder(geometryIn, glm::dvec3(lightMC), closePart)
  {
  }

  bool hasCloseTriangles() const { return !this->closeTriangles.empty(); }

  void addSides(const std::vector<SilhouetteEdge>& silhouette, ShadowVolume& volume);
  void addLightCap(ShadowVolume& volume) const;
  void addDarkTriangles(ShadowVolume& volume);
  void addDarkFan(const std::vector<SilhouetteEdge>& silhouette, ShadowVolume& volume) const;

private:
  /// 1 or -1: casts as it is oriented, or turned over. 0: does not cast.
  int getSign(std::size_t triangle) const
  {
    const int towards = this->facing.towards.test(triangle) ? 1 : 0;
    const bool both = this->casting == Casting::EveryTriangle;
    return both && this->facing.away.test(triangle) ? -1 : towards;
  }

  std::uint32_t chooseApex() const;
  void addFar(std::size_t triangle, bool againstRasterOrder, ShadowVolume& volume) const;

  const SEDGeometry& geometry;
  const LightFacing& facing;
  Casting casting;
  bool farCopiesCoincide;
  std::vector<std::uint32_t> closeTriangles;
  ClosePartBuilder closeBuilder;
};

void Extruder::addSides(const std::vector<SilhouetteEdge>& silhouette, ShadowVolume& volume)
{
  const std::size_t trianglesAnEdge = this->farCopiesCoincide ? 1 : 2;
  const auto doubled = static_cast<std::size_t>(std::count_if(silhouette.begin(), silhouette.end(),
                                                              [](const SilhouetteEdge& edge)
                                                              { return edge.multiplicity == 2; }));
  volume.sides.reserve(trianglesAnEdge * (silhouette.size() - doubled));
  volume.doubledSides.reserve(trianglesAnEdge * doubled);
  for (const SilhouetteEdge& edge : silhouette)
  {
    if (this->hasCloseTriangles() && this->closeBuilder.passesLight(edge.from, edge.to))
    {
      this->closeBuilder.addSide(edge);
      continue;
    }
    const std::uint32_t from = nearCopy(edge.from);
    const std::uint32_t to = nearCopy(edge.to);
    std::vector<ShadowVolume::Triangle>& sides = edge.multiplicity == 2 ? volume.doubledSides : volume.sides;
    sides.push_back({to, from, farCopy(edge.from)});
    if (!this->farCopiesCoincide)
    {
      sides.push_back({to, farCopy(edge.from), farCopy(edge.to)});
    }
  }
}

void Extruder::addLightCap(ShadowVolume& volume) const
{
  for (std::size_t triangle = 0; triangle < this->geometry.getTriangles().size(); ++triangle)
  {
    const int sign = this->getSign(triangle);
    const std::array<std::uint32_t, 3>& corners = this->geometry.getTriangles()[triangle];
    if (sign == 0)
    {
      continue;
    }
    // The light sees the oriented winding counter-clockwise when the sign is 1.
    const bool rasterFacesLight = (sign > 0) != this->geometry.getReversed().test(triangle);
    (rasterFacesLight ? volume.lightCap : volume.lightCapReversed)
        .push_back({nearCopy(corners[0]), nearCopy(corners[1]), nearCopy(corners[2])});
  }
}

/// Closes the far end with far copies that look away from the light.
void Extruder::addDarkTriangles(ShadowVolume& volume)
{
  // On a closed mesh the averted triangles have the same border as those that face the light, the other way
  // round. That needs every edge to have two triangles; any other mesh repeats its light cap, and so does one
  // with a triangle close to the light.
  const bool averted =
      this->casting == Casting::LightFacing && this->geometry.isClosed() && !this->hasCloseTriangles();
  auto close = this->closeTriangles.begin();
  for (std::size_t triangle = 0; triangle < this->geometry.getTriangles().size(); ++triangle)
  {
    const int sign = this->getSign(triangle);
    const bool reversed = this->geometry.getReversed().test(triangle);
    if (close != this->closeTriangles.end() && *close == triangle)
    {
      this->closeBuilder.addDarkFan(*close, sign < 0);
      ++close;
    }
    else if (averted && sign == 0)
    {
      this->addFar(triangle, reversed, volume);
    }
    else if (!averted && sign != 0)
    {
      this->addFar(triangle, (sign > 0) != reversed, volume);
    }
  }
}

void Extruder::addFar(std::size_t triangle, bool againstRasterOrder, ShadowVolume& volume) const
{
  std::array<std::uint32_t, 3> corners = this->geometry.getTriangles()[triangle];
  if (againstRasterOrder)
  {
    std::swap(corners[1], corners[2]);
  }
  volume.darkCap.push_back({farCopy(corners[0]), farCopy(corners[1]), farCopy(corners[2])});
}

/// Any vertex would do that is not at the light. But a fan around one on a straight border has triangles
/// without area, which rounding to a rasteriser's grid gives one in some pixels, and nothing a depth. So it
/// is a corner of a casting triangle from the middle of the list, which on most meshes is not on the border.
std::uint32_t Extruder::chooseApex() const
{
  const std::size_t count = this->geometry.getTriangles().size();
  std::size_t triangle = count / 2;
  for (std::size_t i = 0; i < count && this->getSign(triangle) == 0; ++i)
  {
    triangle = (triangle + 1) % count;
  }
  return this->geometry.getTriangles()[triangle][0];
}

/// Closes the far end with one triangle from each far edge to one of the vertices. As many edges leave each
/// vertex as arrive there, so that the sides of the fan cancel.
void Extruder::addDarkFan(const std::vector<SilhouetteEdge>& silhouette, ShadowVolume& volume) const
{
  if (silhouette.empty())
  {
    return;
  }
  const std::uint32_t apex = this->chooseApex();
  for (const SilhouetteEdge& edge : silhouette)
  {
    if (edge.from == apex || edge.to == apex)
    {
      continue;
    }
    (edge.multiplicity == 2 ? volume.doubledDarkCap : volume.darkCap)
        .push_back({farCopy(apex), farCopy(edge.to), farCopy(edge.from)});
  }
}

} // namespace

ShadowVolume extrudeSilhouette(const SEDGeometry& geometry, const std::vector<SilhouetteEdge>& silhouette,
                               const LightFacing& facing, Casting casting, const glm::dvec4& lightMC,
                               const ShadowVolumeOptions& options)
{
  ShadowVolume volume;
  volume.casting = casting;
  for (const SilhouetteEdge& edge : silhouette)
  {
    volume.silhouetteEdges += edge.multiplicity;
  }

  Extruder extruder(geometry, facing, casting, lightMC, options.farAtInfinity, volume.close);
  extruder.addSides(silhouette, volume);
  if (options.lightCap)
  {
    extruder.addLightCap(volume);
  }
  // Where the far copies of a directional light's volume are one point nothing is open.
  const bool farEndOpen = lightMC.w != 0.0 || !options.farAtInfinity;
  const bool fan = options.darkCap == DarkCap::Fan && !extruder.hasCloseTriangles();
  if (farEndOpen && options.darkCap != DarkCap::None && !fan)
  {
    extruder.addDarkTriangles(volume);
  }
  else if (farEndOpen && fan)
  {
    extruder.addDarkFan(silhouette, volume);
  }

  volume.overlapBound = countCasting(facing, casting);
  if (volume.overlapBound > options.countable)
  {
    volume.overlapBound = boundOverlap(geometry, silhouette, facing, casting, lightMC);
  }
  return volume;
}

} // namespace shadow
