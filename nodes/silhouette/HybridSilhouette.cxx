#include "HybridSilhouette.h"

#include <memory>

#include "CastingTriangles.h"
#include "DirectedEdgeSet.h"
#include "FlatRegions.h"

namespace shadow
{

namespace
{

enum class Agreement
{
  NoneSet,
  AllSet,
  Mixed
};

std::shared_ptr<const FlatRegions> prepareRegions(const SEDGeometry& geometry, double tolerance)
{
  return geometry.getPreparedData().get<FlatRegions>(tolerance, [&geometry, tolerance]
                                                     { return findFlatRegions(geometry, tolerance); });
}

Agreement compareBits(const FlatRegions& regions, const FlatPolygon& polygon, const FacingBits& bits)
{
  bool all = true;
  bool none = true;
  for (std::uint32_t index = polygon.wordsBegin; index < polygon.wordsEnd; ++index)
  {
    const TriangleWord& triangles = regions.words[index];
    const std::uint64_t set = bits.getWords()[triangles.word] & triangles.mask;
    all = all && set == triangles.mask;
    none = none && set == 0;
  }
  return none ? Agreement::NoneSet : all ? Agreement::AllSet : Agreement::Mixed;
}

/// How a whole polygon casts.
struct PolygonFacing
{
  bool mixed = false; ///< the triangles do not agree
  bool towards = false;
  bool away = false; ///< it casts turned over
};

PolygonFacing facePolygon(const FlatRegions& regions, const FlatPolygon& polygon, const LightFacing& facing,
                          Casting casting)
{
  const Agreement towards = compareBits(regions, polygon, facing.towards);
  const Agreement away =
      casting == Casting::EveryTriangle ? compareBits(regions, polygon, facing.away) : Agreement::NoneSet;
  PolygonFacing result;
  result.mixed = towards == Agreement::Mixed || away == Agreement::Mixed;
  result.towards = towards == Agreement::AllSet;
  result.away = away == Agreement::AllSet;
  return result;
}

void setAll(const FlatRegions& regions, const FlatPolygon& polygon, FacingBits& bits)
{
  for (std::uint32_t index = polygon.wordsBegin; index < polygon.wordsEnd; ++index)
  {
    bits.data()[regions.words[index].word] |= regions.words[index].mask;
  }
}

} // namespace

std::vector<SilhouetteEdge> HybridSilhouette::find(const SEDGeometry& geometry, const LightFacing& facing,
                                                   Casting casting) const
{
  const std::shared_ptr<const FlatRegions> regions = prepareRegions(geometry, this->tolerance);
  FacingBits oneByOne = regions->alone;
  DirectedEdgeSet edges;
  for (const FlatPolygon& polygon : regions->polygons)
  {
    const PolygonFacing polygonFacing = facePolygon(*regions, polygon, facing, casting);
    if (polygonFacing.mixed)
    {
      setAll(*regions, polygon, oneByOne);
      continue;
    }
    for (std::uint32_t index = polygon.borderBegin; index < polygon.borderEnd; ++index)
    {
      const auto& [from, to] = regions->border[index];
      if (polygonFacing.towards)
      {
        edges.add(from, to);
      }
      if (polygonFacing.away)
      {
        edges.add(to, from);
      }
    }
  }
  forEachCastingTriangle(geometry, facing, casting, &oneByOne,
                         [&edges](std::uint32_t a, std::uint32_t b, std::uint32_t c)
                         { edges.addTriangle(a, b, c); });
  return edges.getEdges();
}

std::optional<LightFacing> HybridSilhouette::simplifyFacing(const SEDGeometry& geometry,
                                                            const LightFacing& facing) const
{
  if (this->tolerance <= 0.0)
  {
    return std::nullopt;
  }
  const std::shared_ptr<const FlatRegions> regions = prepareRegions(geometry, this->tolerance);
  LightFacing simplified = facing;
  simplified.mixedWords.reset();
  for (const FlatPolygon& polygon : regions->polygons)
  {
    const bool towards = facing.towards.test(polygon.representative);
    if (!towards && !facing.away.test(polygon.representative))
    {
      continue;
    }
    for (std::uint32_t index = polygon.wordsBegin; index < polygon.wordsEnd; ++index)
    {
      const TriangleWord& triangles = regions->words[index];
      std::uint64_t& front = simplified.towards.data()[triangles.word];
      std::uint64_t& back = simplified.away.data()[triangles.word];
      const std::uint64_t casts = (front | back) & triangles.mask;
      front = (front & ~casts) | (towards ? casts : 0);
      back = (back & ~casts) | (towards ? 0 : casts);
    }
  }
  return simplified;
}

} // namespace shadow
