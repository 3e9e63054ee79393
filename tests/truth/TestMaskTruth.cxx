#include <gtest/gtest.h>

#include <stdexcept>

#include "DistanceTransform.h"
#include "MaskError.h"
#include "TruthTestScenes.h"

using namespace shadow::truth;

namespace
{

constexpr glm::dvec3 centre(0.2, 0.1, 1.0);
constexpr double radius = 0.5;

/// Distance from the sphere's centre to the segment from a point to the light, or to the ray towards it.
double clearance(const glm::dvec3& point, const glm::dvec4& light)
{
  const glm::dvec3 way = glm::dvec3(light) - light.w * point;
  double t = std::max(glm::dot(centre - point, way) / glm::dot(way, way), 0.0);
  t = light.w == 0.0 ? t : std::min(t, 1.0);
  return glm::length(point + t * way - centre);
}

/// A floor of side 2 whose middle quarter lies in shadow, seen from above at 64 x 64 pixels.
struct QuarterShadow
{
  QuarterShadow()
  {
    test::addFloor(scene, 1.0);
    test::addFloor(scene, 0.5, 1.0);
    for (std::size_t i = 2; i < 4; ++i)
    {
      scene.triangles[i].hideFront = true;
    }
  }

  Scene scene;
  View view = test::lookingDown(64, 1.0, 10.0);
  Light light{glm::dvec4(0, 0, 1, 0)};
};

std::vector<unsigned char> shifted(const std::vector<unsigned char>& mask, int size, int dx, int dy)
{
  std::vector<unsigned char> result(mask.size(), 255);
  for (int y = std::max(0, dy); y < std::min(size, size + dy); ++y)
  {
    for (int x = std::max(0, dx); x < std::min(size, size + dx); ++x)
    {
      result[y * size + x] = mask[(y - dy) * size + x - dx];
    }
  }
  return result;
}

/// Pixels with one of their four neighbours on the other side of the shadow's edge.
std::vector<glm::dvec2> boundaryPixels(const std::vector<unsigned char>& mask, int size)
{
  std::vector<glm::dvec2> pixels;
  for (int i = 0; i < size * size; ++i)
  {
    const int x = i % size;
    const int y = i / size;
    if ((x > 0 && mask[i - 1] != mask[i]) || (x + 1 < size && mask[i + 1] != mask[i]) ||
        (y > 0 && mask[i - size] != mask[i]) || (y + 1 < size && mask[i + size] != mask[i]))
    {
      pixels.emplace_back(x, y);
    }
  }
  return pixels;
}

double sumOfDistances(const std::vector<glm::dvec2>& from, const std::vector<glm::dvec2>& to)
{
  double sum = 0.0;
  for (const glm::dvec2& p : from)
  {
    double nearest = std::numeric_limits<double>::infinity();
    for (const glm::dvec2& q : to)
    {
      nearest = std::min(nearest, glm::length(p - q));
    }
    sum += nearest;
  }
  return sum;
}

} // namespace

TEST(Truth, SphereOverPlane_MatchesAnalyticShadow)
{
  Scene scene;
  test::addFloor(scene, 3.0);
  test::addSphere(scene, centre, radius, 400);
  const RayCaster caster(scene);
  const View view = test::lookingAt({3, -4, 4}, {0, 0, 0.3}, 320, 240, 50.0);
  const PixelRays rays(view, glm::dvec3(0.0));
  for (const glm::dvec4 light : {glm::dvec4(1.0, 1.5, 4.0, 1), glm::dvec4(0.5, -0.3, 1.0, 0)})
  {
    const MaskTruth truth(caster, view, {light});
    int shadowed = 0;
    for (int i = 0; i < 320 * 240; ++i)
    {
      const Ray ray = rays.through(i % 320 + 0.5, i / 320 + 0.5);
      const glm::dvec3 floor = ray.origin - ray.direction * (ray.origin.z / ray.direction.z);
      const double passes = glm::length(glm::cross(centre - ray.origin, ray.direction));
      const double distance = clearance(floor, light);
      if (passes > radius && (distance > radius || distance < 0.999 * radius) && std::abs(floor.x) < 3.0 &&
          std::abs(floor.y) < 3.0 && ray.direction.z < 0.0)
      {
        shadowed += distance < radius;
        ASSERT_EQ(truth.mask()[i], distance < radius ? 0 : 255) << i % 320 << " " << i / 320;
      }
    }
    EXPECT_GT(shadowed, 500);
  }
}

TEST(Truth, SimpleScene_NearlyAllPixelsAreCertain)
{
  Scene scene;
  test::addFloor(scene, 3.0);
  test::addSphere(scene, centre, radius, 64);
  const RayCaster caster(scene);
  const MaskTruth truth(caster, test::lookingAt({3, -4, 4}, {0, 0, 0.3}, 640, 480),
                        {glm::dvec4(1, 1.5, 4, 1)});
  EXPECT_GT(truth.certainShare(), 0.999);
  EXPECT_LT(truth.certainShare(), 1.0);
}

TEST(Truth, EmptyView_HasNoPixels)
{
  const RayCaster caster((Scene()));
  const MaskTruth truth(caster, View{glm::dmat4(1.0), 0, 0}, {glm::dvec4(0, 0, 1, 0)});
  EXPECT_TRUE(truth.mask().empty());
  EXPECT_EQ(truth.certainShare(), 1.0);
  EXPECT_EQ(compareMask(truth, {}, true).wrongCertainPerMillion, 0.0);
}

TEST(MaskError, SameMask_NoError)
{
  const QuarterShadow made;
  const RayCaster caster(made.scene);
  const MaskTruth truth(caster, made.view, made.light);
  const MaskError error = compareMask(truth, truth.mask(), true);
  EXPECT_EQ(error.pixels, 4096u);
  EXPECT_EQ(error.certain, 4096u);
  EXPECT_EQ(error.wrong, 0u);
  EXPECT_EQ(error.outlineMax, 0.0);
  EXPECT_TRUE(error.firstWrongPixels.empty());
}

TEST(MaskError, ShiftedSquare_OutlineIsTheShift)
{
  const QuarterShadow made;
  const RayCaster caster(made.scene);
  const MaskTruth truth(caster, made.view, made.light);
  for (const int shift : {1, 3, 7})
  {
    const MaskError error = compareMask(truth, shifted(truth.mask(), 64, shift, 0), true);
    EXPECT_EQ(error.wrong, 2u * 32u * shift);
    EXPECT_EQ(error.wrongCertain, error.wrong);
    EXPECT_DOUBLE_EQ(error.wrongCertainPerMillion, 1e6 * error.wrong / 4096.0);
    EXPECT_DOUBLE_EQ(error.outlineMax, shift);
    EXPECT_GT(error.outlineMean, 0.0);
    EXPECT_LT(error.outlineMean, shift);
    EXPECT_EQ(error.firstWrongPixels.front(), glm::ivec2(16, 16));
  }
}

TEST(MaskError, OutlineMean_EqualsBruteForce)
{
  const QuarterShadow made;
  const RayCaster caster(made.scene);
  const MaskTruth truth(caster, made.view, made.light);
  std::vector<unsigned char> mask = shifted(truth.mask(), 64, 2, -5);
  mask[5 * 64 + 60] = 0;
  const std::vector<glm::dvec2> a = boundaryPixels(truth.mask(), 64);
  const std::vector<glm::dvec2> b = boundaryPixels(mask, 64);
  const double expected = (sumOfDistances(a, b) + sumOfDistances(b, a)) / double(a.size() + b.size());
  EXPECT_NEAR(compareMask(truth, mask, false).outlineMean, expected, 1e-12);
}

TEST(MaskError, NoShadowAtAll_OutlineIsTheDiagonal)
{
  const QuarterShadow made;
  const RayCaster caster(made.scene);
  const MaskTruth truth(caster, made.view, made.light);
  const MaskError error = compareMask(truth, std::vector<unsigned char>(4096, 255), false);
  EXPECT_EQ(error.wrongCertain, 1024u);
  EXPECT_EQ(error.certain, 0u);
  EXPECT_DOUBLE_EQ(error.outlineMax, std::hypot(64, 64));
  EXPECT_EQ(error.firstWrongPixels.size(), MaskError::reportedPixels);
}

TEST(MaskError, PixelOnTheEdge_IsWrongButNotCertain)
{
  QuarterShadow made;
  // The shadow's border now runs 1/128 pixel beside the centres of column 16.
  const double shift = (0.5 + 1.0 / 128.0) / 32.0;
  made.scene.triangles.resize(2);
  test::addQuad(made.scene, {-0.5 + shift, -0.5, 1.0}, {1, 0, 0}, {0, 1, 0});
  made.scene.triangles[2].hideFront = made.scene.triangles[3].hideFront = true;
  const RayCaster caster(made.scene);
  const MaskTruth truth(caster, made.view, made.light);
  std::vector<unsigned char> mask = truth.mask();
  EXPECT_EQ(mask[30 * 64 + 16], 255);
  mask[30 * 64 + 16] = 0;
  mask[30 * 64 + 20] = 255;
  for (const bool full : {false, true})
  {
    const MaskError error = compareMask(truth, mask, full);
    EXPECT_EQ(error.wrong, 2u);
    ASSERT_EQ(error.wrongCertain, 1u);
    EXPECT_EQ(error.firstWrongPixels[0], glm::ivec2(20, 30));
  }
  EXPECT_EQ(compareMask(truth, mask, true).certain, 4096u - 2u * 32u);
}

TEST(MaskError, AnotherSize_Throws)
{
  const QuarterShadow made;
  const RayCaster caster(made.scene);
  const MaskTruth truth(caster, made.view, made.light);
  EXPECT_THROW(compareMask(truth, std::vector<unsigned char>(4095), false), std::invalid_argument);
}

TEST(DistanceTransform, EqualsBruteForce)
{
  constexpr int width = 37;
  constexpr int height = 23;
  std::mt19937 random(5);
  for (const int every : {3, 50, 400})
  {
    std::vector<unsigned char> set(width * height);
    for (unsigned char& value : set)
    {
      value = random() % every == 0;
    }
    const std::vector<double> distances = distanceTransform(set, width, height);
    for (int i = 0; i < width * height; ++i)
    {
      double nearest = std::numeric_limits<double>::infinity();
      for (int j = 0; j < width * height; ++j)
      {
        if (set[j] != 0)
        {
          nearest = std::min(nearest, std::hypot(i % width - j % width, i / width - j / width));
        }
      }
      ASSERT_DOUBLE_EQ(distances[i], nearest);
    }
  }
}
