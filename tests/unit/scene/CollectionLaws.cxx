#include "CollectionLaws.h"

#include <array>
#include <utility>

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

namespace shadow::test
{

std::shared_ptr<const SEDGeometry> share(const TriangleSoup& soup, const SEDGeometryOptions& options)
{
  return std::make_shared<const SEDGeometry>(build(soup, options));
}

std::shared_ptr<Transform> place(const std::shared_ptr<Node>& child, const glm::dmat4& matrix)
{
  auto transform = std::make_shared<Transform>();
  transform->matrix = matrix;
  transform->addChild(child);
  return transform;
}

glm::dmat4 moved(double x, double y, double z)
{
  return glm::translate(glm::dmat4(1.0), glm::dvec3(x, y, z));
}

glm::dvec3 worldOf(const VETCollection& collection, std::uint32_t vertex)
{
  return (glm::dvec3(collection.high[vertex]) + glm::dvec3(collection.low[vertex])) * collection.frame.unit +
         collection.frame.originWC;
}

void expectLaws(const VETCollection& collection, double tolerance)
{
  std::size_t vertices = 0;
  std::size_t triangles = 0;
  std::size_t edges = 0;
  for (const VETRange& range : collection.ranges)
  {
    const SEDGeometry& geometry = *range.geometry;
    ASSERT_EQ(range.firstVertex, vertices);
    ASSERT_EQ(range.firstTriangle, triangles);
    ASSERT_EQ(range.firstEdge, edges);
    EXPECT_EQ(collection.find(range.path), &range);
    for (std::size_t v = 0; v < range.countVertices(); ++v)
    {
      const glm::dvec3 model = geometry.getOrigin() + glm::dvec3(geometry.getPositions()[v]);
      const glm::dvec3 world(range.modelToWorld * glm::dvec4(model, 1.0));
      const auto vertex = static_cast<std::uint32_t>(range.firstVertex + v);
      ASSERT_LE(glm::distance(world, worldOf(collection, vertex)), tolerance);
      ASSERT_LE(glm::length(collection.low[vertex]), 1.1e-7f * glm::length(collection.high[vertex]));
    }
    for (std::size_t t = 0; t < range.countTriangles(); ++t)
    {
      for (int corner = 0; corner < 3; ++corner)
      {
        ASSERT_EQ(collection.triangles[triangles + t][corner], vertices + geometry.getTriangles()[t][corner]);
      }
      ASSERT_EQ(collection.reversed.test(triangles + t), geometry.getReversed().test(t) != range.mirrored);
    }
    vertices += range.countVertices();
    triangles += range.countTriangles();
    edges += range.countEdges();
  }
  EXPECT_EQ(collection.high.size(), vertices);
  EXPECT_EQ(collection.low.size(), vertices);
  EXPECT_EQ(collection.triangles.size(), triangles);
  EXPECT_EQ(collection.reversed.size(), triangles);
  EXPECT_EQ(collection.edges.size(), edges);
}

void expectEdgesRunAsTriangles(const VETCollection& collection)
{
  const auto runs = [&collection](std::uint32_t triangle, std::uint32_t from, std::uint32_t to)
  {
    std::array<std::uint32_t, 3> corners = collection.triangles[triangle];
    if (collection.reversed.test(triangle))
    {
      std::swap(corners[1], corners[2]);
    }
    for (int corner = 0; corner < 3; ++corner)
    {
      if (corners[corner] == from && corners[(corner + 1) % 3] == to)
      {
        return true;
      }
    }
    return false;
  };
  for (const Edge& edge : collection.edges)
  {
    ASSERT_TRUE(runs(edge.triangles[0], edge.vertices[0], edge.vertices[1]));
    ASSERT_TRUE(edge.triangles[1] == noTriangle ||
                runs(edge.triangles[1], edge.vertices[1], edge.vertices[0]));
  }
}

} // namespace shadow::test
