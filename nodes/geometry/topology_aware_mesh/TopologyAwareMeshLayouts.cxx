// What a TopologyAwareMesh is as bytes.
#include "TopologyAwareMesh.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include <glm/gtc/packing.hpp>

namespace shadow
{

namespace
{

constexpr std::size_t fullVertex = 7 * 3 * 4;
constexpr std::size_t halfVertex = 3 * 4 + 6 * 3 * 2;
constexpr std::size_t sharedFace = 3 * 4;

/// Appends values to bytes.
class Writer
{
public:
  explicit Writer(std::size_t size) { this->bytes.reserve(size); }

  template <class Value>
  void write(const Value& value)
  {
    const std::size_t place = this->bytes.size();
    this->bytes.resize(place + sizeof(Value));
    std::memcpy(this->bytes.data() + place, &value, sizeof(Value));
  }

  void writeHalves(const glm::vec3& value)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      this->write(glm::packHalf1x16(value[axis]));
    }
  }

  std::vector<unsigned char> bytes;
};

// Folds the lower half of the octahedron over the upper one, and back.
glm::vec2 fold(const glm::vec2& v)
{
  return {(1.0f - std::abs(v.y)) * (v.x >= 0.0f ? 1.0f : -1.0f),
          (1.0f - std::abs(v.x)) * (v.y >= 0.0f ? 1.0f : -1.0f)};
}

} // namespace

std::vector<unsigned char> TopologyAwareMesh::pack(const SEDGeometry& geometry, TAMLayout layout) const
{
  Writer writer(this->getPackedSize(layout));
  const float scale = static_cast<float>(1.0 / geometry.getReach());
  for (std::size_t face = 0; face < this->countFaces(); ++face)
  {
    if (layout == TAMLayout::Shared)
    {
      const float turn = geometry.getReversed().test(face) ? -1.0f : 1.0f;
      for (std::size_t edge = 0; edge < 3; ++edge)
      {
        const EdgeFate fate = this->getFate(geometry, face, edge);
        writer.write(fate == EdgeFate::Never    ? neverPacked
                     : fate == EdgeFate::Border ? borderPacked
                                                : packNormal(turn * this->getNeighbourNormal(face, edge)));
      }
      continue;
    }
    const std::array<std::uint32_t, 3>& corners = geometry.getTriangles()[face];
    for (const std::uint32_t vertex : corners)
    {
      writer.write(geometry.getPositions()[vertex]);
      for (const std::uint32_t corner : corners)
      {
        const glm::vec3& position = geometry.getPositions()[corner];
        layout == TAMLayout::Full ? writer.write(position) : writer.writeHalves(scale * position);
      }
      for (std::size_t edge = 0; edge < 3; ++edge)
      {
        const glm::vec3 normal = this->getNeighbourNormal(face, edge);
        layout == TAMLayout::Full ? writer.write(normal) : writer.writeHalves(normal);
      }
    }
  }
  return std::move(writer.bytes);
}

std::size_t TopologyAwareMesh::getPackedSize(TAMLayout layout) const
{
  switch (layout)
  {
  case TAMLayout::Full:
    return 3 * fullVertex * this->countFaces();
  case TAMLayout::Half:
    return 3 * halfVertex * this->countFaces();
  default:
    return sharedFace * this->countFaces();
  }
}

std::size_t getOriginalSize(std::size_t vertices, std::size_t faces)
{
  const std::size_t index = vertices <= 65535 ? 2 : 4;
  return 44 * vertices + 3 * index * faces;
}

std::uint32_t packNormal(const glm::vec3& normal)
{
  const float sum = std::abs(normal.x) + std::abs(normal.y) + std::abs(normal.z);
  if (!(sum > 0.0f))
  {
    return glm::packSnorm2x16(glm::vec2(0.0f));
  }
  const glm::vec2 flat = glm::vec2(normal) / sum;
  return glm::packSnorm2x16(normal.z >= 0.0f ? flat : fold(flat));
}

glm::vec3 unpackNormal(std::uint32_t packed)
{
  const glm::vec2 flat = glm::unpackSnorm2x16(packed);
  const float z = 1.0f - std::abs(flat.x) - std::abs(flat.y);
  return glm::normalize(glm::vec3(z >= 0.0f ? flat : fold(flat), z));
}

} // namespace shadow
