#include "GeometryTexels.h"

#include <array>
#include <vector>

#include <glm/glm.hpp>

#include <vtkOpenGLState.h>

#include "OpenGL.h"

namespace shadow
{

namespace
{

bool fill(TexelArray& table, const std::vector<glm::uvec4>& texels, std::string& error)
{
  if (!table.allocate(texels.size(), error))
  {
    return false;
  }
  table.upload(texels.data(), 0, texels.size());
  return true;
}

} // namespace

bool GeometryTexels::upload(const SEDGeometry& geometry, std::string& error)
{
  this->rasterOrder = 0; // until all of it is there
  std::vector<glm::uvec4> texels;
  texels.reserve(geometry.getEdges().size());
  for (const Edge& edge : geometry.getEdges())
  {
    texels.emplace_back(edge.vertices[0], edge.vertices[1], edge.triangles[0], edge.triangles[1]);
  }
  if (!fill(this->edges, texels, error) || !this->uploadTriangles(geometry, error) ||
      !this->positions.allocate(geometry.getPositions().size(), error))
  {
    return false;
  }
  this->uploadPositions(geometry);
  this->rasterOrder = geometry.getRasterOrder();
  return true;
}

bool GeometryTexels::uploadTriangles(const SEDGeometry& geometry, std::string& error)
{
  std::vector<glm::uvec4> texels;
  texels.reserve(geometry.getTriangles().size());
  for (std::size_t i = 0; i < geometry.getTriangles().size(); ++i)
  {
    const std::array<std::uint32_t, 3>& corners = geometry.getTriangles()[i];
    texels.emplace_back(corners[0], corners[1], corners[2], geometry.getReversed().test(i) ? 1u : 0u);
  }
  return fill(this->triangles, texels, error);
}

std::size_t GeometryTexels::update(const SEDGeometry& geometry)
{
  this->uploadPositions(geometry);
  std::size_t copied = geometry.getPositions().size();
  if (this->rasterOrder != geometry.getRasterOrder())
  {
    // There is room for them: as many as before.
    std::string error;
    this->rasterOrder = this->uploadTriangles(geometry, error) ? geometry.getRasterOrder() : 0;
    copied += geometry.getTriangles().size();
  }
  return copied;
}

void GeometryTexels::uploadPositions(const SEDGeometry& geometry)
{
  std::vector<glm::vec4> texels;
  texels.reserve(geometry.getPositions().size());
  for (const glm::vec3& position : geometry.getPositions())
  {
    texels.emplace_back(position, 1.0f);
  }
  this->positions.upload(texels.data(), 0, texels.size());
  // The origin of positions stays where it is, so that they are scaled only, which rounds nothing.
  const glm::dvec3 reach = glm::max(glm::abs(geometry.getLowerBound()), glm::abs(geometry.getUpperBound()));
  this->frame = SceneFrame::around(-reach, reach);
}

void GeometryTexels::bind(vtkOpenGLState* state, unsigned int program, int firstUnit) const
{
  this->positions.bind(state, program, firstUnit, "positionTexels", "positionLayer");
  this->triangles.bind(state, program, firstUnit + 1, "triangleTexels", "triangleLayer");
  this->edges.bind(state, program, firstUnit + 2, "edgeTexels", "edgeLayer");
}

void GeometryTexels::release(bool contextLost)
{
  for (TexelArray* table : {&this->positions, &this->triangles, &this->edges})
  {
    table->release(contextLost);
  }
}

std::size_t GeometryTexels::getMemorySize() const
{
  return this->positions.getMemorySize() + this->triangles.getMemorySize() + this->edges.getMemorySize();
}

} // namespace shadow
