// How far what the camera draws is from exact arithmetic: counts, and how near the light was to the plane.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include <glm/gtc/matrix_transform.hpp>

#include <vtkCellArray.h>
#include <vtkOBJReader.h>
#include <vtkPolyData.h>
#include <vtkTriangleFilter.h>

#include "GpuScene.h"

using namespace shadow;
using namespace shadow::test;

namespace
{

/// A sign may be wrong for lights nearer to the plane than this, relative to their distance: single precision
/// where GLSL has no exact arithmetic, see shaders/facing.glsl. @pre  a context is current
double getTolerance()
{
  return hasExactArithmetic() ? 1e-12 : 2e-7;
}

struct Mesh
{
  std::string name;
  std::shared_ptr<const SEDGeometry> geometry;
};

TriangleSoup readModel(const std::string& file)
{
  vtkNew<vtkOBJReader> reader;
  reader->SetFileName(file.c_str());
  vtkNew<vtkTriangleFilter> filter;
  filter->SetInputConnection(reader->GetOutputPort());
  filter->Update();
  vtkPolyData* data = filter->GetOutput();
  TriangleSoup soup;
  for (vtkIdType point = 0; point < data->GetNumberOfPoints(); ++point)
  {
    const double* position = data->GetPoint(point);
    soup.points.emplace_back(position[0], position[1], position[2]);
  }
  for (vtkIdType cell = 0; cell < data->GetNumberOfPolys(); ++cell)
  {
    vtkIdType count = 0;
    const vtkIdType* corners = nullptr;
    data->GetPolys()->GetCellAtId(cell, count, corners);
    soup.triangles.push_back({static_cast<std::uint32_t>(corners[0]), static_cast<std::uint32_t>(corners[1]),
                              static_cast<std::uint32_t>(corners[2])});
  }
  return soup;
}

/// Built-in meshes, and those beside the project.
std::vector<Mesh> findMeshes()
{
  std::vector<Mesh> meshes;
  const auto add = [&meshes](const std::string& name, const TriangleSoup& soup) {
    meshes.push_back({name, std::make_shared<const SEDGeometry>(build(soup))});
  };
  add("torus", makeTorus(1.0, 0.4, 96, 48));
  add("cube", makeCube());
  add("plates", makePlates(20));
  add("soup", makeRandomSoup(2000, 3));
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(SHADOW_MODELS, error))
  {
    if (entry.path().extension() == ".obj")
    {
      add(entry.path().stem().string(), readModel(entry.path().string()));
    }
  }
  return meshes;
}

/// Draws the lights 32 at a time and compares every range.
FacingComparison compare(GpuScene& scene, const std::vector<glm::dvec4>& lightsWC)
{
  FacingComparison sum;
  for (std::size_t first = 0; first < lightsWC.size(); first += 32)
  {
    std::vector<Light> lights;
    for (std::size_t i = first; i < std::min(first + 32, lightsWC.size()); ++i)
    {
      lights.push_back({static_cast<int>(i - first), lightsWC[i]});
    }
    EXPECT_EQ(scene.draw(lights), "");
    for (const VETRange& range : scene.getRanges())
    {
      for (const Light& light : lights)
      {
        sum.add(compareFacing(scene.camera, range, light));
      }
    }
  }
  return sum;
}

void report(const std::string& name, const FacingComparison& result)
{
  std::printf("%-28s %12zu decided %10zu differ, at most %.2g off the plane\n", name.c_str(),
              result.triangles, result.different, result.largestDistance);
}

double sizeOf(const SEDGeometry& geometry)
{
  return glm::distance(geometry.getLowerBound(), geometry.getUpperBound());
}

/// Points in the planes of triangles of the mesh, as near as doubles come, and directions along them.
std::vector<glm::dvec4> makeLightsInPlanes(const SEDGeometry& geometry, std::size_t count,
                                           std::mt19937& random)
{
  std::uniform_int_distribution<std::size_t> any(0, geometry.getTriangles().size() - 1);
  std::uniform_real_distribution<double> factor(-3.0, 3.0);
  std::vector<glm::dvec4> lights;
  for (std::size_t i = 0; i < count; ++i)
  {
    const auto& corners = geometry.getTriangles()[any(random)];
    const glm::dvec3 a(geometry.getPositions()[corners[0]]);
    const glm::dvec3 along = factor(random) * (glm::dvec3(geometry.getPositions()[corners[1]]) - a) +
                             factor(random) * (glm::dvec3(geometry.getPositions()[corners[2]]) - a);
    lights.emplace_back(i % 2 == 0 ? glm::dvec4(geometry.getOrigin() + a + along, 1.0)
                                   : glm::dvec4(along, 0.0));
  }
  return lights;
}

} // namespace

TEST(SilhouetteCameraPrecision, ThousandRandomLights_WrongOnlyAHairFromThePlane)
{
  for (const Mesh& mesh : findMeshes())
  {
    GpuScene scene;
    scene.add(mesh.geometry);
    std::mt19937 random(5);
    std::vector<glm::dvec4> lights;
    for (int i = 0; i < 1000; ++i)
    {
      // Inside, near, and up to ten thousand times as far as the mesh is wide; every fifth directional.
      const double reach = sizeOf(*mesh.geometry) * std::pow(10.0, i % 7 - 2.0);
      lights.emplace_back(mesh.geometry->getOrigin() * (i % 5 == 0 ? 0.0 : 1.0) + randomPoint(random, reach),
                          i % 5 == 0 ? 0.0 : 1.0);
    }
    const FacingComparison result = compare(scene, lights);
    report(mesh.name, result);
    EXPECT_LE(result.largestDistance, getTolerance()) << mesh.name;
    EXPECT_LE(result.different, result.triangles / 1000000) << mesh.name;
  }
}

TEST(SilhouetteCameraPrecision, LightsInThePlaneOfTriangles_WrongOnlyAHairFromThePlane)
{
  for (const Mesh& mesh : findMeshes())
  {
    GpuScene scene;
    scene.add(mesh.geometry);
    std::mt19937 random(6);
    const FacingComparison result = compare(scene, makeLightsInPlanes(*mesh.geometry, 200, random));
    report(mesh.name + ", in planes", result);
    EXPECT_LE(result.largestDistance, getTolerance()) << mesh.name;
  }
}

TEST(SilhouetteCameraPrecision, GridsOfAxisPlanes_LightsInThemExact)
{
  // Whole coordinates: products are exact, and so is the answer "in the plane" of half the triangles.
  GpuScene scene;
  scene.add(makePlates(30));
  scene.add(makeCube(glm::dvec3(8.0, 0.0, 0.0)));
  std::vector<glm::dvec4> lights;
  for (int i = 0; i < 30; ++i)
  {
    lights.emplace_back(0.5 * i, 3.0, i, 1.0);
    lights.emplace_back(1.0, 1.0 * i, 0.0, 0.0);
    lights.emplace_back(7.0, 1.0, 0.25 * i, 1.0);
  }
  const FacingComparison result = compare(scene, lights);
  EXPECT_EQ(result.different, 0u);
}

TEST(SilhouetteCameraPrecision, LargeCoordinates_WrongOnlyWhereTheWorldIsRounded)
{
  for (const Mesh& mesh : findMeshes())
  {
    const double size = sizeOf(*mesh.geometry);
    GpuScene scene;
    // A hundredth wide, ten million away, and another on the other side of the origin.
    const glm::dmat4 small = glm::scale(glm::dmat4(1.0), glm::dvec3(0.01 / size));
    scene.add(mesh.geometry, glm::translate(glm::dmat4(1.0), glm::dvec3(1e7, -1e7, 1e7)) * small);
    scene.add(makeCube(glm::dvec3(-1e7, 0.0, 0.0)));
    std::mt19937 random(7);
    std::vector<glm::dvec4> lights;
    for (int i = 0; i < 96; ++i)
    {
      lights.emplace_back(glm::dvec3(1e7, -1e7, 1e7) + randomPoint(random, i % 2 == 0 ? 0.05 : 1e7), 1.0);
    }
    const FacingComparison result = compare(scene, lights);
    report(mesh.name + ", 0.01 at 1e7", result);
    // 48 bits of 1e7 are 4e-8: a thousandth of a per cent of the mesh, more of its triangles.
    EXPECT_LE(static_cast<double>(result.different), 2e-4 * static_cast<double>(result.triangles))
        << mesh.name;
  }
}

TEST(SilhouetteCameraPrecision, OneMeshAtLargeCoordinates_AsPreciseAsAtZero)
{
  for (const double far : {1e7, -1e9})
  {
    TriangleSoup soup = makeTorus(0.01, 0.004, 64, 32);
    for (glm::dvec3& point : soup.points)
    {
      point += far;
    }
    GpuScene scene;
    scene.add(soup);
    std::mt19937 random(8);
    std::vector<glm::dvec4> lights;
    for (int i = 0; i < 320; ++i)
    {
      lights.emplace_back(far + randomPoint(random, i % 2 == 0 ? 0.05 : 1e5), 1.0);
    }
    const FacingComparison result = compare(scene, lights);
    report("torus, 0.01 alone at " + std::to_string(far), result);
    EXPECT_LE(result.largestDistance, getTolerance());
  }
}
