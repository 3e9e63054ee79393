// pairSides() against OpenMesh, which adds triangle after triangle.

#include <random>

#include <gtest/gtest.h>

#include "EdgeConnector.h"
#include "SidePairing.h"
#include "TestMeshes.h"
#include "TestThreads.h"

namespace shadow::test
{

namespace
{

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

/// @return  whether the triangles are a manifold
bool expectAsOpenMesh(const Triangles& triangles, std::size_t vertices, const ParallelFor& parallelFor = {})
{
  EdgeConnector connector(vertices, triangles.size());
  bool accepted = true;
  for (std::size_t triangle = 0; accepted && triangle < triangles.size(); ++triangle)
  {
    accepted = connector.add(triangles[triangle]);
  }
  std::vector<Edge> edges;
  EXPECT_EQ(pairSides(triangles, vertices, parallelFor, edges), accepted);
  if (accepted)
  {
    const std::vector<Edge> wanted = connector.readEdges();
    EXPECT_EQ(edges.size(), wanted.size());
    for (std::size_t edge = 0; edge < std::min(edges.size(), wanted.size()); ++edge)
    {
      EXPECT_EQ(edges[edge].vertices, wanted[edge].vertices);
      EXPECT_EQ(edges[edge].triangles, wanted[edge].triangles);
    }
  }
  return accepted;
}

Triangles makeFewTriangles(std::mt19937& random, std::size_t count, std::uint32_t vertices)
{
  std::uniform_int_distribution<std::uint32_t> pick(0, vertices - 1);
  Triangles triangles;
  while (triangles.size() < count)
  {
    const std::array<std::uint32_t, 3> corners = {pick(random), pick(random), pick(random)};
    if (corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0])
    {
      triangles.push_back(corners);
    }
  }
  return triangles;
}

} // namespace

TEST(SidePairing, AnyMesh_SameEdgesInTheSameOrderAsOpenMesh)
{
  for (const NamedMesh& mesh : makeAllMeshes())
  {
    SCOPED_TRACE(mesh.name);
    expectAsOpenMesh(mesh.soup.triangles, mesh.soup.points.size());
  }
}

TEST(SidePairing, FewTrianglesOnFewVertices_ManifoldWhereOpenMeshSaysSo)
{
  std::mt19937 random(1);
  std::size_t manifolds = 0;
  constexpr std::size_t rounds = 20000;
  for (std::size_t round = 0; round < rounds && !testing::Test::HasFailure(); ++round)
  {
    const std::uint32_t vertices = 4 + static_cast<std::uint32_t>(round % 4);
    manifolds += expectAsOpenMesh(makeFewTriangles(random, 2 + round % 5, vertices), vertices) ? 1 : 0;
  }
  EXPECT_GT(manifolds, rounds / 20);
  EXPECT_LT(manifolds, rounds - rounds / 20);
}

/// Vertices with a closed fan beside another one are rare among few triangles at random.
TEST(SidePairing, FansAtOneVertex_ManifoldWhereOpenMeshSaysSo)
{
  for (const int closed : {0, 1, 2})
  {
    for (const int open : {0, 1, 2})
    {
      SCOPED_TRACE(std::to_string(closed) + " closed fans, " + std::to_string(open) + " open ones");
      Triangles triangles;
      std::uint32_t vertices = 1;
      for (int fan = 0; fan < closed + open; ++fan)
      {
        const std::uint32_t rim = 4;
        for (std::uint32_t step = 0; step + (fan < closed ? 0 : 1) < rim; ++step)
        {
          triangles.push_back({0, vertices + step, vertices + (step + 1) % rim});
        }
        vertices += rim;
      }
      if (!triangles.empty())
      {
        EXPECT_EQ(expectAsOpenMesh(triangles, vertices), closed == 0 || (closed == 1 && open == 0));
      }
    }
  }
}

TEST(SidePairing, LargeMeshesInThreads_SameEdgesInTheSameOrderAsOpenMesh)
{
  for (const TriangleSoup& soup : {makeTorus(1.0, 0.4, 200, 150), makeFlatSquare(180)})
  {
    for (const std::size_t threads : {1, 2, 7})
    {
      EXPECT_TRUE(expectAsOpenMesh(soup.triangles, soup.points.size(), makeThreads(threads)));
    }
  }
}

} // namespace shadow::test
