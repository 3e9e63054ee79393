#include "KnownScene.h"

#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <utility>

#include <glm/gtc/matrix_transform.hpp>

#include "SEDGeode.h"
#include "SEDGeometry.h"

namespace shadow
{

namespace
{

struct Object
{
  TriangleSoup soup;
  std::vector<glm::dmat4> wcFromMC; ///< one for each time that it is there
};

void addQuad(TriangleSoup& soup, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d)
{
  soup.triangles.push_back({a, b, c});
  soup.triangles.push_back({a, c, d});
}

/// From -1 to 1.
TriangleSoup makeBox()
{
  TriangleSoup box;
  for (const double z : {-1.0, 1.0})
  {
    box.points.insert(box.points.end(), {{-1.0, -1.0, z}, {1.0, -1.0, z}, {1.0, 1.0, z}, {-1.0, 1.0, z}});
  }
  addQuad(box, 0, 3, 2, 1);
  addQuad(box, 4, 5, 6, 7);
  for (const std::uint32_t corner : {0u, 1u, 2u, 3u})
  {
    const std::uint32_t next = (corner + 1) % 4;
    addQuad(box, corner, next, next + 4, corner + 4);
  }
  return box;
}

glm::dmat4 place(const glm::dvec3& centre, const glm::dvec3& size, double degrees)
{
  const glm::dmat4 moved = glm::translate(glm::dmat4(1.0), centre);
  return glm::scale(glm::rotate(moved, glm::radians(degrees), glm::dvec3(0.36, 0.48, 0.8)), size);
}

std::vector<Object> makeObjects()
{
  const TriangleSoup box = makeBox();
  TriangleSoup walled = box;
  addQuad(walled, 0, 2, 6, 4);
  TriangleSoup doubled = {{{-1, 0, -1}, {0, 0.7, -1}, {1, 0, -1}, {-1, 0, 1}, {0, 0.7, 1}, {1, 0, 1}}, {}};
  addQuad(doubled, 0, 3, 4, 1);
  addQuad(doubled, 1, 4, 5, 2);
  addQuad(doubled, 0, 3, 4, 1);
  TriangleSoup floor = {{{-3, 0, -3}, {3, 0, -3}, {3, 0, 3}, {-3, 0, 3}}, {}};
  addQuad(floor, 0, 3, 2, 1);
  // Above the eye.
  TriangleSoup awning = {{{-2.35, 7.5, 3.3}, {-1.95, 7.5, 3.1}, {-0.9, 7.5, 4.7}, {-1.6, 7.5, 5.2}}, {}};
  addQuad(awning, 0, 3, 2, 1);
  // The point light is in the plane of the mirrored box's side.
  const glm::dmat4 mirrored = place({-2.55, 1.2, -0.9}, {-0.45, 0.4, 0.5}, 0.0);
  return {{box, {place({-1.5, 1.5, 1.2}, {0.4, 0.45, 0.45}, 40.0), mirrored}},
          {walled, {place({-0.1, 1.6, -0.9}, {0.5, 0.45, 0.4}, 25.0)}},
          {doubled, {place({0.3, 1.2, 1.4}, {0.6, 0.6, 0.6}, 15.0)}},
          {floor, {glm::dmat4(1.0)}},
          {awning, {glm::dmat4(1.0)}}};
}

// In units of @p ray; infinite when the ray passes.
double hit(const glm::dvec3 (&corners)[3], const glm::dvec3& start, const glm::dvec3& ray)
{
  constexpr double none = std::numeric_limits<double>::infinity();
  const glm::dvec3 edge1 = corners[1] - corners[0];
  const glm::dvec3 edge2 = corners[2] - corners[0];
  const glm::dvec3 across = glm::cross(ray, edge2);
  const double volume = glm::dot(edge1, across);
  if (volume == 0.0)
  {
    return none;
  }
  const glm::dvec3 from = start - corners[0];
  const double u = glm::dot(from, across) / volume;
  const glm::dvec3 around = glm::cross(from, edge1);
  const double v = glm::dot(ray, around) / volume;
  const double distance = glm::dot(edge2, around) / volume;
  // Farther than where the ray comes from a surface.
  return u >= 0.0 && v >= 0.0 && u + v <= 1.0 && distance > 1e-6 ? distance : none;
}

} // namespace

KnownScene::KnownScene(bool parallelView)
    : lights{{0, {-3.0, 9.0, 4.0, 1.0}}, {maximumLights - 1, {-0.78, 1.0, 0.19, 0.0}}}
{
  const glm::dmat4 viewFromWC = glm::lookAt(glm::dvec3(0, 7, 6), glm::dvec3(0, 0.3, 0), glm::dvec3(0, 1, 0));
  const glm::dmat4 clipFromView = parallelView ? glm::ortho(-2.85, 2.85, -2.85, 2.85, 1.0, 20.0)
                                               : glm::perspective(glm::radians(35.7), 1.0, 1.0, 20.0);
  this->view = makeView(clipFromView * viewFromWC, side, side);
  this->wcFromClip = glm::inverse(this->view.clipFromWC);
  int number = 0;
  for (const Object& object : makeObjects())
  {
    for (const glm::dmat4& wcFromMC : object.wcFromMC)
    {
      for (const auto& triangle : object.soup.triangles)
      {
        const auto corner = [&](std::size_t i)
        { return glm::dvec3(wcFromMC * glm::dvec4(object.soup.points[triangle[i]], 1.0)); };
        this->triangles.push_back({{corner(0), corner(1), corner(2)}, number});
      }
      ++number;
    }
  }
}

void KnownScene::addTo(Group& root) const
{
  for (Object& object : makeObjects())
  {
    std::string error;
    const auto geode = std::make_shared<SEDGeode>(
        std::make_shared<const SEDGeometry>(*buildSEDGeometry(std::move(object.soup), {}, error)));
    for (const glm::dmat4& wcFromMC : object.wcFromMC)
    {
      const auto transform = std::make_shared<Transform>();
      transform->matrix = wcFromMC;
      transform->addChild(geode);
      root.addChild(transform);
    }
  }
}

const KnownScene::Triangle* KnownScene::findFirst(const glm::dvec3& start, const glm::dvec3& ray,
                                                  double& distance) const
{
  const Triangle* first = nullptr;
  for (const Triangle& triangle : this->triangles)
  {
    const double farther = hit(triangle.corners, start, ray);
    if (farther < distance)
    {
      distance = farther;
      first = &triangle;
    }
  }
  return first;
}

KnownScene::Answer KnownScene::findAnswer(const glm::dvec2& pixel, std::size_t light, int& object) const
{
  const auto unproject = [&](double depth)
  {
    const glm::dvec4 point = this->wcFromClip * glm::dvec4(2.0 * pixel / double{side} - 1.0, depth, 1.0);
    return glm::dvec3(point) / point.w;
  };
  const glm::dvec3 start = unproject(-1.0);
  const glm::dvec3 ray = unproject(1.0) - start;
  double distance = std::numeric_limits<double>::infinity();
  const Triangle* seen = this->findFirst(start, ray, distance);
  object = seen != nullptr ? seen->object : -1;
  if (seen == nullptr)
  {
    return Answer::Reached;
  }
  const glm::dvec3 point = start + distance * ray;
  const glm::dvec4& position = this->lights[light].positionWC;
  const glm::dvec3 toLight = glm::dvec3(position) - position.w * point;
  const glm::dvec3& corner = seen->corners[0];
  const glm::dvec3 normal = glm::normalize(glm::cross(seen->corners[1] - corner, seen->corners[2] - corner));
  const double slope = -std::copysign(1.0, glm::dot(normal, ray)) * glm::dot(normal, glm::normalize(toLight));
  if (std::abs(slope) < 0.02)
  {
    return Answer::Uncertain;
  }
  double toOccluder = position.w != 0.0 ? 1.0 : std::numeric_limits<double>::infinity();
  const bool reached = slope > 0.0 && this->findFirst(point, toLight, toOccluder) == nullptr;
  return reached ? Answer::Reached : Answer::Shadow;
}

std::vector<KnownScene::Answer> KnownScene::findAnswers(std::size_t light) const
{
  constexpr std::size_t row = side + 1;
  std::vector<std::pair<Answer, int>> corners(row * row);
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    corners[i].first = this->findAnswer({i % row, i / row}, light, corners[i].second);
  }
  std::vector<Answer> answers;
  for (std::size_t pixel = 0; pixel < std::size_t{side} * side; ++pixel)
  {
    const std::size_t corner = pixel / side * row + pixel % side;
    const bool same = corners[corner] == corners[corner + 1] && corners[corner] == corners[corner + row] &&
                      corners[corner] == corners[corner + row + 1];
    answers.push_back(same ? corners[corner].first : Answer::Uncertain);
  }
  return answers;
}

} // namespace shadow
