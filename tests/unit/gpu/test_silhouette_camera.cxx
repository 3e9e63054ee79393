// The facing that the camera draws is the facing that exact arithmetic finds.

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include <glm/gtc/matrix_transform.hpp>

#include "GLInspection.h"
#include "GpuScene.h"
#include "OpenGL.h"
#include "ShadowVolume.h"

using namespace shadow;
using namespace shadow::test;

namespace
{

std::vector<Light> makeLights(int count, double reach, std::uint32_t seed)
{
  std::mt19937 random(seed);
  std::vector<Light> lights;
  for (int i = 0; i < count; ++i)
  {
    lights.push_back({i, glm::dvec4(randomPoint(random, reach), i % 2 == 0 ? 1.0 : 0.0)});
  }
  return lights;
}

/// All ranges and lights as exact arithmetic has them.
void expectExact(const GpuScene& scene, const std::vector<Light>& lights)
{
  for (const VETRange& range : scene.getRanges())
  {
    for (const Light& light : lights)
    {
      const FacingComparison result = compareFacing(scene.camera, range, light);
      ASSERT_GT(result.triangles, 0u);
      // Random lights: nearer than this to a plane is none of them.
      EXPECT_EQ(result.different, 0u)
          << "light " << light.index << ", relative distance from the plane " << result.largestDistance;
    }
  }
}

} // namespace

TEST(SilhouetteCamera, EveryMesh32Lights_Exact)
{
  for (const NamedMesh& mesh : makeAllMeshes())
  {
    SCOPED_TRACE(mesh.name);
    GpuScene scene;
    scene.add(mesh.soup);
    const std::vector<Light> lights = makeLights(32, 3.0, 1);
    ASSERT_EQ(scene.draw(lights), "");
    expectExact(scene, lights);
  }
}

TEST(SilhouetteCamera, AnySideAndSeveralLayers_Exact)
{
  const std::vector<Light> lights = makeLights(4, 3.0, 2);
  for (const int side : {1, 3, 16, 100, 0})
  {
    GpuScene scene(side);
    scene.add(makeTorus(1.0, 0.4, 24, 12)); // 576 triangles
    scene.add(makeSphere(1.0, 16, 12), glm::translate(glm::dmat4(1.0), glm::dvec3(1.0, 2.0, 0.0)));
    ASSERT_EQ(scene.draw(lights), "") << side;
    EXPECT_EQ(scene.camera.getTexels().getSize(), 576u + 352u);
    EXPECT_EQ(scene.camera.getTexels().getLayers() > 1, side > 0 && side < 31) << side;
    expectExact(scene, lights);
  }
}

TEST(SilhouetteCamera, SharedMirroredAndStretchedGeodes_Exact)
{
  GpuScene scene(64);
  const auto geometry = std::make_shared<const SEDGeometry>(build(makeTorus(1.0, 0.4, 32, 16)));
  const glm::dmat4 turned = glm::rotate(glm::dmat4(1.0), 0.8, glm::dvec3(1.0, 2.0, 0.5));
  scene.add(geometry);
  scene.add(geometry, glm::scale(turned, glm::dvec3(1.0, -1.0, 1.0)));
  scene.add(geometry, glm::scale(turned, glm::dvec3(0.01, 3.0, 1.0)));
  scene.add(geometry, glm::translate(turned, glm::dvec3(100.0, -30.0, 7.0)));
  const std::vector<Light> lights = makeLights(32, 20.0, 3);
  ASSERT_EQ(scene.draw(lights), "");
  expectExact(scene, lights);
}

TEST(SilhouetteCamera, LightIndicesWithGaps_BitsOfTheseOnly)
{
  GpuScene scene;
  scene.add(makeSphere(1.0, 12, 8));
  std::vector<Light> lights = makeLights(3, 4.0, 4);
  lights[0].index = 31;
  lights[1].index = 0;
  lights[2].index = 7;
  ASSERT_EQ(scene.draw(lights), "");
  expectExact(scene, lights);
  LightFacing facing;
  scene.camera.getFacing(scene.getRanges()[0], Light{8, lights[2].positionWC}, facing);
  EXPECT_EQ(facing.towards.countSet() + facing.away.countSet(), 0u);
}

TEST(SilhouetteCamera, LightsThatAreNotFinite_NoBits)
{
  GpuScene scene;
  scene.add(makeCube());
  const std::vector<Light> lights = {
      {0, {NAN, 0.0, 0.0, 1.0}}, {1, {4.0, 4.0, 4.0, 1.0}}, {2, {0.0, INFINITY, 0.0, 0.0}}};
  ASSERT_EQ(scene.draw(lights), "");
  for (const Light& light : lights)
  {
    LightFacing facing;
    scene.camera.getFacing(scene.getRanges()[0], light, facing);
    EXPECT_EQ(facing.towards.countSet() + facing.away.countSet(), light.index == 1 ? 12u : 0u);
  }
}

TEST(SilhouetteCamera, LightAtACorner_ItsTrianglesHaveNoBits)
{
  GpuScene scene;
  scene.add(makeSphere(1.0, 12, 8), glm::translate(glm::dmat4(1.0), glm::dvec3(10.0, -3.0, 2.0)));
  scene.collector.collect(scene.root);
  const VETRange& range = scene.getRanges()[0];
  const SEDGeometry& geometry = *range.geometry;
  std::vector<Light> lights;
  for (int i = 0; i < 32; ++i)
  {
    const glm::dvec3 corner(geometry.getPositions()[static_cast<std::size_t>(2 * i)]);
    lights.push_back({i, range.modelToWorld * glm::dvec4(geometry.getOrigin() + corner, 1.0)});
  }
  ASSERT_EQ(scene.draw(lights), "");
  for (int i = 0; i < 32; ++i)
  {
    LightFacing facing;
    scene.camera.getFacing(range, lights[static_cast<std::size_t>(i)], facing);
    std::size_t touching = 0;
    for (std::size_t t = 0; t < range.countTriangles(); ++t)
    {
      const auto& corners = geometry.getTriangles()[t];
      if (std::find(corners.begin(), corners.end(), static_cast<std::uint32_t>(2 * i)) != corners.end())
      {
        ++touching;
        EXPECT_EQ(facingOf(facing, t), 0) << "light " << i;
      }
    }
    EXPECT_GT(touching, 2u);
  }
}

TEST(SilhouetteCamera, OnlyPositionsChanged_OnlyMovedTrianglesAreUploaded)
{
  GpuScene scene(16);
  auto geometry = std::make_shared<const SEDGeometry>(build(makeTorus(1.0, 0.4, 24, 12))); // 576 triangles
  const auto mover = scene.add(geometry);
  scene.add(makeCube(glm::dvec3(0.0, -3.0, 0.0)));
  const std::vector<Light> lights = makeLights(8, 4.0, 5);
  ASSERT_EQ(scene.draw(lights), "");
  EXPECT_EQ(scene.triangles.upload(scene.collector.getCollection()), 0u);
  const GLuint texture = scene.camera.getTexels().getTexture();
  for (int frame = 1; frame <= 10; ++frame)
  {
    if (frame % 2 == 0)
    {
      mover->matrix = glm::rotate(mover->matrix, 0.2, glm::dvec3(1.0, 1.0, 0.0));
    }
    else
    {
      TriangleSoup soup = makeTorus(1.0, 0.4, 24, 12);
      for (glm::dvec3& point : soup.points)
      {
        point.x += 0.2 * std::sin(3.0 * point.y + frame);
      }
      SEDGeometryOptions options;
      options.previous = geometry.get();
      geometry = std::make_shared<const SEDGeometry>(build(soup, options));
      mover->clearChildren();
      mover->addChild(std::make_shared<SEDGeode>(geometry));
    }
    ASSERT_EQ(scene.collector.collect(scene.root), VETCollector::Change::Positions);
    ASSERT_EQ(scene.triangles.upload(scene.collector.getCollection()), 576u);
    ASSERT_EQ(scene.draw(lights), "");
    EXPECT_EQ(scene.camera.getTexels().getTexture(), texture);
    expectExact(scene, lights);
  }
}

TEST(SilhouetteCamera, EmptyScene_NothingDrawnNothingFails)
{
  GpuScene scene;
  EXPECT_EQ(scene.draw(makeLights(2, 1.0, 6)), "");
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST(SilhouetteCamera, MoreThanTheTextureHolds_RefusedThenDrawsAgain)
{
  GpuScene scene(1);
  const auto large = scene.add(makeSphere(1.0, 64, 64));
  scene.add(makeCube(glm::dvec3(5.0, 0.0, 0.0)));
  GLint layers = 0;
  glGetIntegerv(GL_MAX_ARRAY_TEXTURE_LAYERS, &layers);
  ASSERT_GT(64 * 63 * 2, layers);
  const std::vector<Light> lights = makeLights(2, 8.0, 7);
  EXPECT_NE(scene.draw(lights).find("texels"), std::string::npos);
  large->visible = false;
  ASSERT_EQ(scene.draw(lights), "");
  expectExact(scene, lights);
}

TEST(SilhouetteCamera, AnyStateBefore_DrawsRightAndGLAsFound)
{
  GpuScene scene(16);
  scene.add(makeTorus(1.0, 0.4, 24, 12));
  const std::vector<Light> lights = makeLights(3, 4.0, 8);
  ASSERT_EQ(scene.draw(lights), "");
  vtkOpenGLState* state = scene.window.getState();
  state->vtkglEnable(GL_SCISSOR_TEST);
  state->vtkglScissor(3, 4, 5, 6);
  state->vtkglViewport(1, 2, 30, 20);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthFunc(GL_NEVER);
  state->vtkglEnable(GL_STENCIL_TEST);
  state->vtkglEnable(GL_BLEND);
  state->vtkglColorMask(GL_FALSE, GL_TRUE, GL_FALSE, GL_TRUE);
  state->vtkglEnable(GL_CULL_FACE);
  glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
  glEnable(GL_COLOR_LOGIC_OP);
  glLogicOp(GL_AND);
  glPointSize(7.0f);
  const GLStateValues before = readGLState();
  ASSERT_EQ(scene.draw(lights), "");
  const GLStateValues after = readGLState();
  EXPECT_EQ(after, before);
  glDisable(GL_COLOR_LOGIC_OP);
  glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  glPointSize(1.0f);
  expectExact(scene, lights);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST(SilhouetteCamera, ReleasedAndDrawn100Times_NothingIsLeft)
{
  GpuScene scene(16);
  const auto mover = scene.add(makeTorus(1.0, 0.4, 24, 12));
  const std::vector<Light> lights = makeLights(3, 4.0, 9);
  ASSERT_EQ(scene.draw(lights), ""); // VTK keeps the program
  scene.camera.release();
  scene.triangles.release();
  const auto objects = countGLObjects(scene.window);
  for (int round = 0; round < 100; ++round)
  {
    mover->matrix = glm::translate(mover->matrix, glm::dvec3(0.1, 0.0, 0.0));
    ASSERT_EQ(scene.draw(lights), "");
    EXPECT_GT(countGLObjects(scene.window).at("buffers"), objects.at("buffers"));
    EXPECT_GT(scene.camera.getMemorySize() + scene.triangles.getMemorySize(), 576u * 76u);
    scene.camera.release();
    scene.triangles.release();
    ASSERT_EQ(countGLObjects(scene.window), objects);
    EXPECT_EQ(scene.camera.getMemorySize() + scene.triangles.getMemorySize(), 0u);
  }
  ASSERT_EQ(scene.draw(lights), "");
  expectExact(scene, lights);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}
