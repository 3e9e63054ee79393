#include "EdgeBufferSilhouette.h"

#include <array>
#include <cstdint>
#include <memory>

#include "CastingTriangles.h"
#include "TriangleSides.h"

namespace shadow
{

namespace
{

/// Bits of an entry. Each of F and B is followed by the direction of the triangle that it is left over from:
/// set for one that runs through the edge backwards.
enum : std::uint8_t
{
  frontBit = 1,
  frontBackwards = 2,
  backBit = 4,
  backBackwards = 8
};

/// How often more an edge is run through forwards than backwards, for each value of its entry, when averted
/// triangles are turned over.
std::array<int, 16> makeRuns()
{
  std::array<int, 16> runs{};
  for (unsigned entry = 0; entry < runs.size(); ++entry)
  {
    const int front = (entry & frontBit) == 0 ? 0 : (entry & frontBackwards) == 0 ? 1 : -1;
    const int back = (entry & backBit) == 0 ? 0 : (entry & backBackwards) == 0 ? -1 : 1;
    runs[entry] = front + back;
  }
  return runs;
}

std::vector<std::uint8_t> fillBuffer(const SEDGeometry& geometry, const LightFacing& facing, Casting casting)
{
  const auto sides = geometry.getPreparedData().get<TriangleSides>(
      0.0,
      [&geometry] { return TriangleSides(geometry.getEdges().toVector(), geometry.getTriangles().size()); });
  std::vector<std::uint8_t> buffer(geometry.getEdges().size(), 0);
  const auto flip = [&buffer, &sides](std::uint32_t triangle, unsigned bit)
  {
    for (const std::uint32_t side : (*sides)[triangle])
    {
      buffer[side >> 1] ^= static_cast<std::uint8_t>(bit | (side & 1u ? bit << 1 : 0u));
    }
  };
  forEachTriangle(facing.towards, nullptr, [&flip](std::uint32_t triangle) { flip(triangle, frontBit); });
  if (casting == Casting::EveryTriangle)
  {
    forEachTriangle(facing.away, nullptr, [&flip](std::uint32_t triangle) { flip(triangle, backBit); });
  }
  return buffer;
}

} // namespace

std::vector<SilhouetteEdge> EdgeBufferSilhouette::find(const SEDGeometry& geometry, const LightFacing& facing,
                                                       Casting casting) const
{
  static const std::array<int, 16> runsOf = makeRuns();
  const std::vector<std::uint8_t> buffer = fillBuffer(geometry, facing, casting);
  std::vector<SilhouetteEdge> silhouette;
  auto entry = buffer.begin();
  forEachEdge(geometry.getEdgeTable(), [&](std::uint32_t first, std::uint32_t side, std::uint32_t)
              { addSide(geometry, first, side, runsOf[*entry++], silhouette); });
  return silhouette;
}

} // namespace shadow
