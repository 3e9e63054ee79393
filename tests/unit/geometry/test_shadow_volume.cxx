// Laws of shadow volumes: closed, and enclosing a point as often as triangles stand before its light.

#include <random>

#include <gtest/gtest.h>

#include "SilhouetteFinder.h"
#include "TestMeshes.h"
#include "VolumeOracle.h"

namespace shadow::test
{

namespace
{

ShadowVolume extrude(const SEDGeometry& geometry, const glm::dvec4& light, Casting casting, DarkCap darkCap)
{
  const LightFacing facing = computeFacing(geometry, light);
  const auto silhouette = makeSilhouetteFinder(SilhouetteMethod::BruteForce)->find(geometry, facing, casting);
  ShadowVolumeOptions options;
  options.darkCap = darkCap;
  return extrudeSilhouette(geometry, silhouette, facing, casting, light, options);
}

/// Lights of both kinds, near, far and amidst the mesh, and one exactly at a vertex.
std::vector<glm::dvec4> makeLights(const SEDGeometry& geometry, std::uint32_t seed)
{
  std::mt19937 random(seed);
  std::vector<glm::dvec4> lights;
  for (int round = 0; round < 8; ++round)
  {
    lights.emplace_back(randomPoint(random, 1.0), 0.0);
    lights.emplace_back(randomPoint(random, 1.0), 1.0);
    lights.emplace_back(randomPoint(random, 6.0), 1.0);
  }
  lights.emplace_back(0, 0, 1, 0);
  lights.emplace_back(glm::dvec3(geometry.getPositions()[random() % geometry.getPositions().size()]), 1.0);
  return lights;
}

bool isEdgeOf(const std::vector<SilhouetteEdge>& silhouette, std::uint32_t from, std::uint32_t to)
{
  for (const SilhouetteEdge& edge : silhouette)
  {
    if (edge.from == from && edge.to == to)
    {
      return true;
    }
  }
  return false;
}

/// A point near the light that nothing shades: with the light's neighbourhood empty, just off the light.
glm::dvec3 findLitPoint(const glm::dvec3& point, const glm::dvec4& light, std::mt19937& random)
{
  const glm::dvec3 offset = randomPoint(random, 1.0);
  return light.w == 0.0 ? point + 20.0 * glm::normalize(glm::dvec3(light)) + offset
                        : glm::dvec3(light) + 1e-4 * offset;
}

} // namespace

TEST(ShadowVolume, WithBothCaps_IsClosed)
{
  for (const NamedMesh& mesh : makeAllMeshes())
  {
    const SEDGeometry geometry = build(mesh.soup);
    for (const glm::dvec4& light : makeLights(geometry, 1))
    {
      SCOPED_TRACE(mesh.name + (light.w == 0.0 ? ", directional" : ", point"));
      for (const DarkCap darkCap : {DarkCap::Triangles, DarkCap::Fan})
      {
        const ShadowVolume volume = extrude(geometry, light, Casting::EveryTriangle, darkCap);
        EXPECT_TRUE(balanceVolume(geometry, volume, light.w == 0.0).isClosed());
        EXPECT_EQ(volume.casting, Casting::EveryTriangle);
        const Casting chosen = chooseCasting(geometry, light);
        EXPECT_TRUE(balanceVolume(geometry, extrude(geometry, light, chosen, darkCap), light.w == 0.0).isClosed());
      }
    }
  }
}

TEST(ShadowVolume, WithoutCaps_NearEdgesAreTheSilhouette)
{
  for (const NamedMesh& mesh : makeAllMeshes())
  {
    SCOPED_TRACE(mesh.name);
    const SEDGeometry geometry = build(mesh.soup);
    for (const double w : {0.0, 1.0})
    {
      const glm::dvec4 light(2.1, 3.3, 4.7, w);
      const LightFacing facing = computeFacing(geometry, light);
      const Casting casting = chooseCasting(geometry, light);
      const auto silhouette =
          makeSilhouetteFinder(SilhouetteMethod::BruteForce)->find(geometry, facing, casting);
      const ShadowVolume volume = extrudeSilhouette(geometry, silhouette, facing, casting, light,
                                                    ShadowVolumeOptions{false, DarkCap::None});
      EXPECT_TRUE(volume.lightCap.empty() && volume.lightCapReversed.empty() && volume.darkCap.empty() &&
                  volume.doubledDarkCap.empty());
      EXPECT_EQ(volume.getSideCount(), (w == 0.0 ? 1 : 2) * volume.silhouetteEdges);
      for (const ShadowVolume::Triangle& side : volume.sides)
      {
        if (side[1] % 2 == 0)
        {
          EXPECT_TRUE(isEdgeOf(silhouette, side[1] / 2, side[0] / 2));
        }
      }
    }
  }
}

TEST(ShadowVolume, ClosedMesh_CapsAreTheMeshOnce)
{
  for (const NamedMesh& mesh : makeClosedMeshes())
  {
    SCOPED_TRACE(mesh.name);
    const SEDGeometry geometry = build(mesh.soup);
    const ShadowVolume volume =
        extrude(geometry, glm::dvec4(5, 6, 7, 1), Casting::LightFacing, DarkCap::Triangles);
    EXPECT_EQ(volume.lightCap.size() + volume.lightCapReversed.size() + volume.darkCap.size(),
              geometry.getTriangles().size());
    EXPECT_EQ(volume.getSideCount() + volume.getCapCount(),
              geometry.getTriangles().size() + 2 * volume.silhouetteEdges);
  }
}

TEST(ShadowVolume, LightCaps_KeepRasterOrderAndFaceAsTheySay)
{
  const glm::dvec4 light(2.3, -3.1, 4.2, 1);
  for (const NamedMesh& mesh : makeAllMeshes())
  {
    SCOPED_TRACE(mesh.name);
    const SEDGeometry geometry = build(mesh.soup);
    const ShadowVolume volume = extrude(geometry, light, Casting::EveryTriangle, DarkCap::None);
    for (const bool reversed : {false, true})
    {
      for (const auto& [a, b, c] : reversed ? volume.lightCapReversed : volume.lightCap)
      {
        const glm::dvec3 p(geometry.getPositions()[a / 2]);
        const glm::dvec3 q(geometry.getPositions()[b / 2]);
        const glm::dvec3 r(geometry.getPositions()[c / 2]);
        EXPECT_EQ(a % 2 + b % 2 + c % 2, 0u);
        EXPECT_LE(p.x, q.x);
        EXPECT_LE(q.x, r.x);
        EXPECT_EQ(glm::dot(glm::cross(q - p, r - p), glm::dvec3(light) - p) < 0.0, reversed);
      }
    }
  }
}

TEST(ShadowVolume, AnyMesh_EnclosesAPointAsOftenAsTrianglesBlockIt)
{
  std::mt19937 random(2);
  for (const NamedMesh& mesh : makeAllMeshes())
  {
    const SEDGeometry geometry = build(mesh.soup);
    for (const glm::dvec4& light : makeLights(geometry, 3))
    {
      SCOPED_TRACE(mesh.name + (light.w == 0.0 ? ", directional" : ", point"));
      const ShadowVolume volume = extrude(geometry, light, Casting::EveryTriangle, DarkCap::Triangles);
      for (int round = 0; round < 25; ++round)
      {
        const glm::dvec3 point = randomPoint(random, 3.0);
        const glm::dvec3 lit = findLitPoint(point, light, random);
        if (countBlockers(geometry, lit, light) == 0)
        {
          EXPECT_EQ(countEnclosing(geometry, volume, light, point, lit),
                    static_cast<int>(countBlockers(geometry, point, light)));
        }
      }
    }
  }
}

TEST(ShadowVolume, FanAndTriangles_EncloseTheSamePoints)
{
  std::mt19937 random(4);
  for (const NamedMesh& mesh : makeAllMeshes())
  {
    SCOPED_TRACE(mesh.name);
    const SEDGeometry geometry = build(mesh.soup);
    for (int round = 0; round < 10; ++round)
    {
      const glm::dvec4 light(8.0 * glm::normalize(randomPoint(random, 1.0)), 1.0);
      const Casting casting = chooseCasting(geometry, light);
      const ShadowVolume triangles = extrude(geometry, light, casting, DarkCap::Triangles);
      const ShadowVolume fan = extrude(geometry, light, casting, DarkCap::Fan);
      EXPECT_LE(fan.darkCap.size() + 2 * fan.doubledDarkCap.size(), fan.silhouetteEdges);
      for (int sample = 0; sample < 20; ++sample)
      {
        const glm::dvec3 point = randomPoint(random, 3.0);
        const glm::dvec3 lit = glm::dvec3(light) + randomPoint(random, 1e-3);
        EXPECT_EQ(countEnclosing(geometry, fan, light, point, lit),
                  countEnclosing(geometry, triangles, light, point, lit));
      }
    }
  }
}

// A fan around a point of a straight border would have triangles without area.
TEST(ShadowVolume, FanOverAStraightBorder_EveryTriangleHasAnArea)
{
  for (const std::uint32_t divisions : {1u, 2u, 3u, 8u, 30u})
  {
    const SEDGeometry geometry = build(makeFlatSquare(divisions));
    const std::vector<glm::vec3>& positions = geometry.getPositions();
    const ShadowVolume fan =
        extrude(geometry, {0.3, 0.2, 3.0, 1.0}, Casting::EveryTriangle, DarkCap::Fan);
    EXPECT_GE(fan.darkCap.size(), 4 * divisions - 2);
    for (const ShadowVolume::Triangle& face : fan.darkCap)
    {
      const glm::dvec3 a(positions[face[0] / 2]), b(positions[face[1] / 2]), c(positions[face[2] / 2]);
      EXPECT_GT(glm::length(glm::cross(b - a, c - a)), 1e-3) << divisions;
    }
  }
}

TEST(ShadowVolume, LightFacing_BlocksExactlyWhatEveryTriangleBlocks)
{
  std::mt19937 random(5);
  for (const NamedMesh& mesh : makeClosedMeshes())
  {
    SCOPED_TRACE(mesh.name);
    const SEDGeometry geometry = build(mesh.soup);
    int blocked = 0;
    for (int round = 0; round < 20; ++round)
    {
      const glm::dvec4 light(4.0 * glm::normalize(randomPoint(random, 1.0)), round % 2);
      ASSERT_EQ(chooseCasting(geometry, light), Casting::LightFacing);
      const LightFacing facing = computeFacing(geometry, light);
      const ShadowVolume volume = extrude(geometry, light, Casting::LightFacing, DarkCap::Triangles);
      for (int sample = 0; sample < 40; ++sample)
      {
        const glm::dvec3 point = randomPoint(random, 2.5);
        const bool shaded = countBlockers(geometry, point, light) > 0;
        EXPECT_EQ(countBlockers(geometry, point, light, &facing) > 0, shaded);
        const glm::dvec3 lit = findLitPoint(point, light, random);
        EXPECT_EQ(countEnclosing(geometry, volume, light, point, lit) > 0, shaded);
        blocked += shaded ? 1 : 0;
      }
    }
    EXPECT_GT(blocked, 50);
  }
}

TEST(ShadowVolume, VertexAtTheLight_HasNoFaces)
{
  const SEDGeometry geometry = build(makeSphere(1.0, 12, 8));
  const glm::dvec4 light(glm::dvec3(geometry.getPositions()[30]), 1.0);
  const LightFacing facing = computeFacing(geometry, light);
  const Casting casting = chooseCasting(geometry, light);
  EXPECT_EQ(casting, Casting::EveryTriangle);
  for (const DarkCap darkCap : {DarkCap::Triangles, DarkCap::Fan})
  {
    const auto silhouette =
        makeSilhouetteFinder(SilhouetteMethod::BruteForce)->find(geometry, facing, casting);
    const ShadowVolume volume = extrudeSilhouette(geometry, silhouette, facing, casting, light,
                                                  ShadowVolumeOptions{true, darkCap});
    for (const auto* faces : {&volume.sides, &volume.doubledSides, &volume.lightCap, &volume.lightCapReversed,
                              &volume.darkCap, &volume.doubledDarkCap})
    {
      for (const ShadowVolume::Triangle& face : *faces)
      {
        EXPECT_TRUE(face[0] / 2 != 30 && face[1] / 2 != 30 && face[2] / 2 != 30);
      }
    }
  }
}

TEST(ShadowVolume, Casting_IsLightFacingOnlyForClosedMeshesAndLightsOutside)
{
  const SEDGeometry closed = build(makeSphere(1.0, 12, 8));
  const SEDGeometry open = build(makeOpenCylinder(12));
  for (const glm::dvec4 outside :
       {glm::dvec4(3, 0, 0, 1), glm::dvec4(0, 0, 1, 0), glm::dvec4(0.1, 0.1, 1.01, 1)})
  {
    EXPECT_EQ(chooseCasting(closed, outside), Casting::LightFacing);
    EXPECT_EQ(chooseCasting(open, outside), Casting::EveryTriangle);
  }
  EXPECT_EQ(chooseCasting(closed, glm::dvec4(0, 0, 0, 1)), Casting::EveryTriangle);
  EXPECT_EQ(chooseCasting(closed, glm::dvec4(0, 0, 1, 1)), Casting::EveryTriangle);
}

} // namespace shadow::test
