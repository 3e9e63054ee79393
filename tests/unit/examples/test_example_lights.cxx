#include "Camera.h"
#include "Lights.h"

#include <gtest/gtest.h>
#include <vtkMath.h>

#include <cmath>
#include <random>

namespace
{

using namespace shadow::examples;

const vtkBoundingBox BOX(-1.0, 1.0, 0.0, 1.0, -2.0, 2.0);

LightOption spot(const Vector3& position, const Vector3& target, double coneAngle)
{
  LightOption light;
  light.kind = LightOption::Kind::Spot;
  light.position = position;
  light.target = target;
  light.coneAngle = coneAngle;
  return light;
}

TEST(CanReach, PointAndDirectional_Always)
{
  LightOption light;
  light.position = {50.0, 50.0, 50.0};
  EXPECT_TRUE(canReach(light, BOX));
  light.kind = LightOption::Kind::Directional;
  EXPECT_TRUE(canReach(light, BOX));
}

TEST(CanReach, SpotTurnedAway_Not)
{
  EXPECT_FALSE(canReach(spot({0.0, 5.0, 0.0}, {0.0, 6.0, 0.0}, 45.0), BOX));
  EXPECT_FALSE(canReach(spot({0.0, 5.0, 0.0}, {1.0, 5.0, 0.0}, 60.0), BOX));
  EXPECT_TRUE(canReach(spot({0.0, 5.0, 0.0}, {0.0, 0.0, 0.0}, 1.0), BOX));
}

TEST(CanReach, ConeOfNinetyAndMore_Unlimited)
{
  EXPECT_TRUE(canReach(spot({0.0, 5.0, 0.0}, {0.0, 6.0, 0.0}, 90.0), BOX));
  EXPECT_TRUE(canReach(spot({0.0, 5.0, 0.0}, {0.0, 6.0, 0.0}, 180.0), BOX));
}

TEST(CanReach, SpotInsideBox_Always)
{
  EXPECT_TRUE(canReach(spot({0.0, 0.5, 0.0}, {0.0, 6.0, 0.0}, 1.0), BOX));
}

TEST(CanReach, RimMeetsMiddleOfEdge_FoundThereOnly)
{
  // The nearest of the box is the middle of the edge x = 1, y = 1, 45 degrees below the axis; the corners are
  // farther.
  EXPECT_FALSE(canReach(spot({2.0, 2.0, 0.0}, {1.0, 2.0, 0.0}, 18.4), BOX));
  EXPECT_TRUE(canReach(spot({2.0, 2.0, 0.0}, {1.0, 2.0, 0.0}, 18.5), BOX));
}

TEST(CanReach, RandomSpots_AgreeWithSampledBox)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> coordinate(-4.0, 4.0), angle(1.0, 89.0), unit(0.0, 1.0);
  for (int i = 0; i < 300; ++i)
  {
    const LightOption light =
        spot({coordinate(random), coordinate(random), coordinate(random)},
             {coordinate(random), coordinate(random), coordinate(random)}, angle(random));
    const double rim = std::cos(vtkMath::RadiansFromDegrees(light.coneAngle));
    bool met = false;
    for (int sample = 0; sample < 2000 && !met; ++sample)
    {
      double towards[3], axis[3];
      for (int k = 0; k < 3; ++k)
      {
        towards[k] = BOX.GetMinPoint()[k] + unit(random) * BOX.GetLength(k) - light.position[k];
        axis[k] = light.target[k] - light.position[k];
      }
      met = vtkMath::Dot(towards, axis) >= rim * vtkMath::Norm(towards) * vtkMath::Norm(axis);
    }
    // samples may miss a narrow meeting, so only one direction is certain
    EXPECT_TRUE(!met || canReach(light, BOX)) << "spot " << i;
  }
}

TEST(TurnLight, FullTurn_ComesBack)
{
  const LightOption light = spot({1.0, 2.0, 3.0}, {0.5, 0.0, 0.25}, 20.0);
  const Vector3 centre = {0.1, 7.0, -0.2};
  LightOption turned = light;
  for (int i = 0; i < 8; ++i)
  {
    turned = turnLight(turned, centre, 45.0);
    EXPECT_EQ(turned.position[1], light.position[1]);
  }
  for (int k = 0; k < 3; ++k)
  {
    EXPECT_NEAR(turned.position[k], light.position[k], 1e-12);
    EXPECT_NEAR(turned.target[k], light.target[k], 1e-12);
  }
}

TEST(TurnLight, QuarterTurn_AgainstTheClockSeenFromAbove)
{
  LightOption light;
  light.position = {3.0, 1.0, 0.0};
  light = turnLight(light, {1.0, 0.0, 0.0}, 90.0);
  EXPECT_NEAR(light.position[0], 1.0, 1e-12);
  EXPECT_NEAR(light.position[2], -2.0, 1e-12);
}

TEST(ChooseCamera, EveryPoint_InView)
{
  for (const double aspect : {0.4, 1.0, 1.78, 5.0})
  {
    CameraSubject subject;
    for (int i = 0; i < 8; ++i)
    {
      subject.points.emplace_back();
      BOX.GetCorner(i, subject.points.back().data());
    }
    subject.lights = {chooseLight(BOX)};
    subject.floorHeight = 0.0;
    subject.aspect = aspect;
    const CameraOption camera = chooseCamera(subject);
    Vector3 forward, right, up;
    vtkMath::Subtract(camera.focalPoint, camera.position, forward);
    vtkMath::Normalize(forward.data());
    vtkMath::Cross(forward.data(), camera.viewUp.data(), right.data());
    vtkMath::Normalize(right.data());
    vtkMath::Cross(right.data(), forward.data(), up.data());
    const double tangent = std::tan(vtkMath::RadiansFromDegrees(0.5 * camera.viewAngle));
    for (const Vector3& point : subject.points)
    {
      Vector3 offset;
      vtkMath::Subtract(point, camera.position, offset);
      const double depth = vtkMath::Dot(offset.data(), forward.data());
      ASSERT_GT(depth, 0.0);
      EXPECT_LT(std::abs(vtkMath::Dot(offset.data(), up.data())), tangent * depth);
      EXPECT_LT(std::abs(vtkMath::Dot(offset.data(), right.data())), tangent * aspect * depth);
    }
  }
}

} // namespace
