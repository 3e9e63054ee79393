// Where the GPU is said to be sure how triangles face a light, it is right: for lights next to their planes,
// of meshes anywhere, of any scale.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include <glm/gtc/matrix_transform.hpp>

#include "GPUFacingBound.h"
#include "GpuScene.h"
#include "SilhouetteProbe.h"

using namespace shadow;
using namespace shadow::test;

namespace
{

/// Triangles a hundred to a million times as long as high, which have nothing to do with each other.
TriangleSoup makeSlivers(std::uint32_t triangles)
{
  TriangleSoup soup = makeRandomSoup(triangles, 4);
  std::mt19937 random(5);
  for (const auto& corners : soup.triangles)
  {
    const glm::dvec3 middle = 0.5 * (soup.points[corners[0]] + soup.points[corners[1]]);
    soup.points[corners[2]] =
        glm::mix(middle, soup.points[corners[2]], std::pow(10.0, -2.0 - 4.0 * (random() % 100) / 100.0));
  }
  return soup;
}

std::vector<NamedMesh> makeMeshes()
{
  return {{"square", makeFlatSquare(1)},
          {"cube", makeCube()},
          {"torus", makeTorus(1.0, 0.4, 48, 24)},
          {"soup", makeRandomSoup(300, 3)},
          {"slivers", makeSlivers(300)}};
}

double uniform(std::mt19937& random, double lower, double upper)
{
  return std::uniform_real_distribution<double>(lower, upper)(random);
}

/// A place up to a hundred times as far as the mesh is large, a scale from 1e-3 to 1e3; every third time not
/// the same along all axes, every fourth without turning.
glm::dmat4 makePlacement(std::mt19937& random, int which)
{
  glm::dmat4 matrix = glm::translate(glm::dmat4(1.0), randomPoint(random, which % 5 == 0 ? 0.0 : 100.0));
  if (which % 4 != 0)
  {
    matrix = glm::rotate(matrix, uniform(random, 0.0, 6.0), glm::normalize(randomPoint(random, 1.0)));
  }
  const double scale = std::pow(10.0, uniform(random, -3.0, 3.0));
  const glm::dvec3 along(1.0, std::pow(10.0, uniform(random, -2.0, 2.0)), -0.5);
  return glm::scale(matrix, scale * (which % 3 == 0 ? along : glm::dvec3(1.0)));
}

/// A light next to the plane of a triangle, by 1e-12 to 1e-16 of the mesh's reach, times what planes are
/// rougher by: above the triangle, next to a corner of it, far off, or at infinity. Relative to the
/// geometry's origin.
glm::dvec4 makeLightNearPlane(const SEDGeometry& geometry, std::mt19937& random, int which, double rougher)
{
  const auto& corners = geometry.getTriangles()[random() % geometry.getTriangles().size()];
  const auto at = [&](std::size_t corner) { return glm::dvec3(geometry.getPositions()[corners[corner]]); };
  const glm::dvec3 u = at(1) - at(0);
  const glm::dvec3 v = at(2) - at(0);
  const glm::dvec3 normal = glm::cross(u, v);
  const double off = rougher * std::pow(10.0, uniform(random, -16.0, -12.0)) * (which % 2 == 0 ? 1.0 : -1.0);
  const double spread = which % 4 == 0 ? 1.0 : which % 4 == 1 ? 1e-13 : 50.0;
  const glm::dvec3 along = spread * (uniform(random, -0.5, 0.5) * u + uniform(random, -0.5, 0.5) * v);
  return which % 4 == 3 ? glm::dvec4(glm::normalize(along) + off * glm::normalize(normal), 0.0)
                        : glm::dvec4(at(0) + along + off * geometry.getReach() * glm::normalize(normal), 1.0);
}

/// For every other light, by how much the mesh's thinnest triangle turns more than one that is as high as
/// long.
double roughnessOf(const SEDGeometry& geometry, int which)
{
  return which / 4 % 2 == 0 ? 1.0 : geometry.getSharpness();
}

/// Exact facing by computeFacing() with a bound, which has to be the one without, and to ask every triangle
/// that may be unsure. @return  what it returns
bool face(const SEDGeometry& geometry, const glm::dvec4& lightMC, const GPUFacingBound& bound)
{
  LightFacing facing;
  const bool sure = computeFacing(geometry, lightMC, bound, facing);
  const LightFacing expected = computeFacing(geometry, lightMC);
  EXPECT_EQ(facing.towards.getWords(), expected.towards.getWords());
  EXPECT_EQ(facing.away.getWords(), expected.away.getWords());
  bool allSure = true;
  for (std::uint32_t triangle = 0; triangle < geometry.getTriangles().size(); ++triangle)
  {
    allSure = allSure && bound.isSure(geometry, triangle, lightMC);
  }
  EXPECT_EQ(sure, allSure);
  return sure;
}

struct Found
{
  int sure = 0;
  int unsure = 0;
  std::size_t unsureDifferent = 0; ///< triangles
};

/// Looks at all lights and meshes of a scene. Lights are sure or not of one mesh each.
void look(GpuScene& scene, const std::vector<Light>& lights, Found& found)
{
  ASSERT_EQ(scene.draw(lights), "");
  for (const VETRange& range : scene.getRanges())
  {
    const SEDGeometry& geometry = *range.geometry;
    for (const Light& light : lights)
    {
      const glm::dvec4 lightMC = *lightToModel(light, range.modelToWorld, geometry.getOrigin());
      const GPUFacingBound bound = GPUFacingBound::inScene(
          geometry, range.modelToWorld, scene.collector.getCollection().frame, light, lightMC);
      const bool sure = face(geometry, lightMC, bound);
      const FacingComparison result = compareFacing(scene.camera, range, light);
      ++(sure ? found.sure : found.unsure);
      found.unsureDifferent += sure ? 0 : result.different;
      if (sure)
      {
        EXPECT_EQ(result.different, 0u) << "up to " << result.largestDistance << " off the plane";
      }
    }
  }
}

class FacingNearPlanes : public testing::Test
{
protected:
  void SetUp() override
  {
    const GpuScene scene;
    if (!hasExactArithmetic())
    {
      GTEST_SKIP() << "no exact arithmetic on this GL";
    }
  }
};

/// Has a body fill a scene that has a mesh in it, in many places, with lights to look at.
template <class Fill>
Found lookEverywhere(std::mt19937& random, int placements, const Fill& fill)
{
  Found found;
  for (const NamedMesh& mesh : makeMeshes())
  {
    const auto geometry = std::make_shared<const SEDGeometry>(build(mesh.soup));
    for (int placement = 0; placement < placements; ++placement)
    {
      SCOPED_TRACE(mesh.name + ", placement " + std::to_string(placement));
      GpuScene scene;
      const glm::dmat4 matrix = makePlacement(random, placement);
      scene.add(geometry, matrix);
      look(scene, fill(scene, geometry, matrix, placement), found);
    }
  }
  return found;
}

} // namespace

TEST_F(FacingNearPlanes, LightsNextToPlanes_SureMeansRight)
{
  std::mt19937 random(11);
  const auto fill = [&random](GpuScene& scene, const std::shared_ptr<const SEDGeometry>& geometry,
                              const glm::dmat4& matrix, int placement)
  {
    // With another mesh beside it of which the frame is larger, up to 1e11 times.
    const double larger = placement % 2 == 0 ? 1.0 : std::pow(10.0, placement % 12);
    std::vector<Light> lights;
    for (int i = 0; i < maximumLights; ++i)
    {
      const double rougher = larger * roughnessOf(*geometry, i);
      const glm::dvec4 lightMC = makeLightNearPlane(*geometry, random, i, rougher);
      lights.push_back({i, worldFromRelative(*geometry, matrix) * lightMC});
    }
    if (placement % 2 != 0)
    {
      scene.add(geometry, glm::scale(matrix, glm::dvec3(larger)));
    }
    return lights;
  };
  const Found found = lookEverywhere(random, 24, fill);
  std::printf("%d lights sure, %d not, where %zu triangles differ\n", found.sure, found.unsure,
              found.unsureDifferent);
  EXPECT_GT(found.unsureDifferent, 0u) << "no light was hard";
}

TEST_F(FacingNearPlanes, LightsAnywhere_AreSure)
{
  std::mt19937 random(12);
  const auto fill = [&random](GpuScene& /*scene*/, const std::shared_ptr<const SEDGeometry>& /*geometry*/,
                              const glm::dmat4& matrix, int /*placement*/)
  {
    std::vector<Light> lights;
    for (int i = 0; i < maximumLights; ++i)
    {
      const glm::dvec4 light(randomPoint(random, std::pow(10.0, i % 4)), i % 3 == 0 ? 0.0 : 1.0);
      lights.push_back({i, matrix * light});
    }
    return lights;
  };
  const Found found = lookEverywhere(random, 12, fill);
  std::printf("%d lights sure, %d not\n", found.sure, found.unsure);
  EXPECT_EQ(found.unsure, 0);
}

// What compute shaders list comes of the facing that all methods without the silhouette camera evaluate.
TEST_F(FacingNearPlanes, EvaluatedFromTheTables_SureMeansTheSilhouetteOfTheCPU)
{
  std::mt19937 random(13);
  int sure = 0;
  int unsure = 0;
  for (const NamedMesh& mesh : makeMeshes())
  {
    for (int placement = 0; placement < 8; ++placement)
    {
      SCOPED_TRACE(mesh.name + ", placement " + std::to_string(placement));
      TriangleSoup soup = mesh.soup;
      const glm::dmat4 matrix = makePlacement(random, placement);
      for (glm::dvec3& point : soup.points)
      {
        point = glm::dvec3(matrix * glm::dvec4(point, 1.0));
      }
      SilhouetteProbe probe(build(soup));
      if (!probe.canCompute())
      {
        GTEST_SKIP() << "no compute shaders";
      }
      std::vector<glm::dvec4> lightsMC;
      for (int i = 0; i < maximumLights; ++i)
      {
        lightsMC.push_back(
            makeLightNearPlane(probe.getGeometry(), random, i, roughnessOf(probe.getGeometry(), i)));
      }
      ComputeSilhouette method;
      probe.find(method, lightsMC);
      const SilhouetteProbe::Silhouettes found = probe.read(method);
      for (std::size_t i = 0; i < lightsMC.size(); ++i)
      {
        const GPUFacingBound bound = GPUFacingBound::inModel(probe.getGeometry(), lightsMC[i]);
        if (face(probe.getGeometry(), lightsMC[i], bound))
        {
          EXPECT_TRUE(isSameSilhouette(found[i], findOnCPU(probe.getGeometry(), lightsMC[i])))
              << "light " << i;
          ++sure;
        }
        else
        {
          ++unsure;
        }
      }
      method.release(false);
    }
  }
  std::printf("%d lights sure, %d not\n", sure, unsure);
  EXPECT_GT(sure, 100);
}
