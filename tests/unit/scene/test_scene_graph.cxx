// Laws of the scene graph, without any graphics.

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "CasterCuller.h"
#include "SEDGeode.h"
#include "SEDVisitor.h"
#include "SVStateVisitor.h"
#include "SceneBoundsVisitor.h"
#include "SilhouetteFinder.h"
#include "TestMeshes.h"
#include "View.h"

using namespace shadow;
using namespace shadow::test;

namespace
{

std::shared_ptr<SEDGeode> makeGeode(const TriangleSoup& soup)
{
  return std::make_shared<SEDGeode>(std::make_shared<const SEDGeometry>(build(soup)));
}

View viewFrom(const glm::dvec3& eye, const glm::dvec3& centre)
{
  const glm::dmat4 clip =
      glm::perspective(0.9, 4.0 / 3.0, 0.1, 100.0) * glm::lookAt(eye, centre, glm::dvec3(0.0, 1.0, 0.0));
  return makeView(clip, 400, 300);
}

/// What a rendering asks of the graph. @return volumes that were built
int refresh(Group& root, const View& view, const std::vector<Light>& lights, const SilhouetteFinder& finder)
{
  SceneBoundsVisitor bounds(view);
  root.accept(bounds);
  CasterCuller culler(view, lights, bounds.getBounds(), StencilMethod::ZFail);
  root.accept(culler);
  SEDVisitor facer(SEDVisitor::Stage::Face, lights, finder);
  root.accept(facer);
  SEDVisitor extruder(SEDVisitor::Stage::Extrude, lights, finder);
  root.accept(extruder);
  return extruder.getRebuiltVolumes();
}

/// The same, always with one finder, as an effect has it.
int refresh(Group& root, const View& view, const std::vector<Light>& lights)
{
  static const auto finder = makeSilhouetteFinder(SilhouetteMethod::BruteForce);
  return refresh(root, view, lights, *finder);
}

/// Thesis, figure 4.2: one geode that six paths lead to, through groups and transforms with several parents.
class Figure42 : public testing::Test
{
protected:
  Figure42()
  {
    for (int i = 0; i < 3; ++i)
    {
      this->inner.push_back(std::make_shared<Transform>());
      this->inner.back()->matrix = glm::translate(glm::dmat4(1.0), glm::dvec3(3.0 * i - 3.0, 0.0, 0.0));
      this->inner.back()->addChild(this->geode);
      this->middle->addChild(this->inner.back());
    }
    for (int i = 0; i < 2; ++i)
    {
      this->outer.push_back(std::make_shared<Transform>());
      this->outer.back()->matrix = glm::translate(glm::dmat4(1.0), glm::dvec3(0.0, 0.0, 3.0 * i));
      this->outer.back()->addChild(this->middle);
      this->root.addChild(this->outer.back());
    }
  }

  Group root; // as the effect node
  std::shared_ptr<SEDGeode> geode = makeGeode(makeSphere(1.0, 12, 8));
  std::shared_ptr<Group> middle = std::make_shared<Group>();
  std::vector<std::shared_ptr<Transform>> inner;
  std::vector<std::shared_ptr<Transform>> outer;
  View view = viewFrom(glm::dvec3(0.0, 6.0, 14.0), glm::dvec3(0.0));
  std::vector<Light> lights{{0, {0.4, 9.0, 0.1, 1.0}}, {1, {5.0, 8.0, 3.0, 1.0}}, {2, {0.3, 1.0, 0.2, 0.0}}};
};

glm::dmat4 randomTransform(std::mt19937& random, bool mirrored)
{
  std::uniform_real_distribution<double> angle(0.0, 6.28);
  std::uniform_real_distribution<double> exponent(-3.0, 3.0);
  glm::dmat4 matrix = glm::translate(glm::dmat4(1.0), randomPoint(random, 50.0));
  matrix = glm::rotate(matrix, angle(random), glm::normalize(randomPoint(random, 1.0)));
  matrix = glm::scale(matrix, glm::dvec3(std::pow(10.0, exponent(random)), std::pow(10.0, exponent(random)),
                                         std::pow(10.0, exponent(random))));
  matrix = glm::rotate(matrix, angle(random), glm::normalize(randomPoint(random, 1.0)));
  return mirrored ? glm::scale(matrix, glm::dvec3(1.0, -1.0, 1.0)) : matrix;
}

} // namespace

TEST_F(Figure42, SixPathsThreeLights_18Volumes)
{
  EXPECT_EQ(refresh(this->root, this->view, this->lights), 18);
  EXPECT_EQ(this->geode->countVolumes(), 18u);
  EXPECT_EQ(this->geode->getPathStates().size(), 6u);
  EXPECT_EQ(this->geode->getSharedGeometry().use_count(), 1) << "all paths share one geometry";
}

TEST_F(Figure42, NothingChanged_NothingRebuilt)
{
  refresh(this->root, this->view, this->lights);
  EXPECT_EQ(refresh(this->root, this->view, this->lights), 0);
  this->view = viewFrom(glm::dvec3(1.0, 6.0, 14.0), glm::dvec3(0.0));
  EXPECT_EQ(refresh(this->root, this->view, this->lights), 0) << "another camera";
}

TEST_F(Figure42, AnotherFinder_EverythingIsRebuilt)
{
  for (const SilhouetteMethod method : {SilhouetteMethod::BruteForce, SilhouetteMethod::Hybrid})
  {
    // Finders of which the second may lie where the first was.
    const auto finder = makeSilhouetteFinder(method);
    EXPECT_EQ(refresh(this->root, this->view, this->lights, *finder), 18) << toString(method);
    EXPECT_EQ(refresh(this->root, this->view, this->lights, *finder), 0) << toString(method);
  }
}

TEST_F(Figure42, OneTransformMoved_VolumesOfItsPathsAreRebuilt)
{
  refresh(this->root, this->view, this->lights);
  this->inner[1]->matrix = glm::translate(this->inner[1]->matrix, glm::dvec3(0.0, 0.2, 0.0));
  // Two paths lead through it. The directional light stays the same in object space when a path is only
  // moved.
  EXPECT_EQ(refresh(this->root, this->view, this->lights), 4);
  this->outer[0]->matrix = glm::rotate(this->outer[0]->matrix, 0.1, glm::dvec3(0.0, 1.0, 0.0));
  EXPECT_EQ(refresh(this->root, this->view, this->lights), 9);
}

TEST_F(Figure42, OneLightMoved_ItsSixVolumesAreRebuilt)
{
  refresh(this->root, this->view, this->lights);
  this->lights[1].positionWC.y = 8.5;
  EXPECT_EQ(refresh(this->root, this->view, this->lights), 6);
}

TEST_F(Figure42, PathGone_ItsVolumesAreDropped)
{
  refresh(this->root, this->view, this->lights);
  this->middle->clearChildren();
  this->middle->addChild(this->inner[0]);
  this->geode->dropUnusedPaths();
  refresh(this->root, this->view, this->lights);
  this->geode->dropUnusedPaths();
  EXPECT_EQ(this->geode->countVolumes(), 6u);
}

TEST_F(Figure42, InvisibleOrNotCasting_NoVolumes)
{
  this->inner[0]->visible = false;
  EXPECT_EQ(refresh(this->root, this->view, this->lights), 12);
  this->inner[1]->casting = false;
  refresh(this->root, this->view, this->lights);
  SVStateVisitor mode(RenderMode{RenderMode::What::Volume, 2, StencilCount::ZFail});
  this->root.accept(mode);
  EXPECT_EQ(this->geode->renderMode.what, RenderMode::What::Volume);
  EXPECT_EQ(this->geode->renderMode.light, 2);
}

TEST(LightToModel, AnyTransform_FacingOfEveryTriangleStays)
{
  std::mt19937 random(4);
  const SEDGeometry geometry = build(makeTorus(1.0, 0.4, 12, 9));
  for (int i = 0; i < 200; ++i)
  {
    const bool mirrored = i % 2 == 1;
    const glm::dmat4 modelToWorld = randomTransform(random, mirrored);
    glm::dvec4 lightWC(modelToWorld * glm::dvec4(randomPoint(random, 3.0), 1.0));
    lightWC.w = i % 3 == 0 ? 0.0 : 1.0;
    const auto lightMC = lightToModel(Light{0, lightWC}, modelToWorld, geometry.getOrigin());
    ASSERT_TRUE(lightMC);
    const LightFacing facing = computeFacing(geometry, *lightMC);
    for (std::size_t t = 0; t < geometry.getTriangles().size(); ++t)
    {
      glm::dvec3 corner[3];
      for (int c = 0; c < 3; ++c)
      {
        const glm::dvec3 pointMC =
            geometry.getOrigin() + glm::dvec3(geometry.getPositions()[geometry.getTriangles()[t][c]]);
        corner[c] = glm::dvec3(modelToWorld * glm::dvec4(pointMC, 1.0));
      }
      const glm::dvec3 normal = glm::cross(corner[1] - corner[0], corner[2] - corner[0]);
      const glm::dvec3 toLight = glm::dvec3(lightWC) - corner[0] * lightWC.w;
      const bool inwards = geometry.getReversed().test(t) != mirrored;
      const double height = glm::dot(normal, toLight) * (inwards ? -1.0 : 1.0);
      if (std::abs(height) > 1e-6 * glm::length(normal) * glm::length(toLight))
      {
        ASSERT_EQ(facing.towards.test(t), height > 0.0) << "transform " << i << ", triangle " << t;
      }
    }
  }
}

TEST(LightToModel, FlatteningTransform_Nothing)
{
  const glm::dmat4 flat = glm::scale(glm::dmat4(1.0), glm::dvec3(1.0, 0.0, 1.0));
  EXPECT_FALSE(lightToModel(Light{0, {1.0, 2.0, 3.0, 1.0}}, flat, glm::dvec3(0.0)));
}
