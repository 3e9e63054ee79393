#pragma once

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include <glm/glm.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "TruthScene.h"

namespace shadow::truth::test
{

inline Triangle makeTriangle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
{
  Triangle triangle;
  triangle.a = a;
  triangle.b = b;
  triangle.c = c;
  return triangle;
}

/// Two triangles; counter-clockwise seen from the side cross(u, v) points to.
inline void addQuad(Scene& scene, const glm::dvec3& corner, const glm::dvec3& u, const glm::dvec3& v)
{
  scene.triangles.push_back(makeTriangle(corner, corner + u, corner + u + v));
  scene.triangles.push_back(makeTriangle(corner, corner + u + v, corner + v));
}

/// The square |x|, |y| <= half at height z, facing up.
inline void addFloor(Scene& scene, double half, double z = 0.0)
{
  addQuad(scene, {-half, -half, z}, {2.0 * half, 0.0, 0.0}, {0.0, 2.0 * half, 0.0});
}

/// A closed sphere of latitudes and longitudes, facing outwards.
inline void addSphere(Scene& scene, const glm::dvec3& centre, double radius, int slices)
{
  const int stacks = slices / 2;
  const auto at = [&](int i, int j)
  {
    // The poles and the seam have to be the same points for all their triangles.
    const double theta = glm::pi<double>() * i / stacks;
    const double phi = glm::two_pi<double>() * (j % slices) / slices;
    const double ring = i == 0 || i == stacks ? 0.0 : std::sin(theta);
    return centre + radius * glm::dvec3(ring * std::cos(phi), ring * std::sin(phi), std::cos(theta));
  };
  for (int i = 0; i < stacks; ++i)
  {
    for (int j = 0; j < slices; ++j)
    {
      if (i + 1 < stacks)
      {
        scene.triangles.push_back(makeTriangle(at(i, j), at(i + 1, j), at(i + 1, j + 1)));
      }
      if (i > 0)
      {
        scene.triangles.push_back(makeTriangle(at(i, j), at(i + 1, j + 1), at(i, j + 1)));
      }
    }
  }
}

inline Scene randomSoup(unsigned seed, int triangles, double size)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  const auto point = [&] { return glm::dvec3(unit(random), unit(random), unit(random)); };
  Scene scene;
  for (int i = 0; i < triangles; ++i)
  {
    const glm::dvec3 centre = point();
    scene.triangles.push_back(
        makeTriangle(centre + size * point(), centre + size * point(), centre + size * point()));
    scene.triangles.back().casts = i % 5 != 0;
    scene.triangles.back().hideFront = i % 7 == 0;
    scene.triangles.back().hideBack = i % 11 == 0;
  }
  return scene;
}

inline Scene transformed(Scene scene, const glm::dmat4& matrix)
{
  for (Triangle& triangle : scene.triangles)
  {
    for (glm::dvec3* p : {&triangle.a, &triangle.b, &triangle.c})
    {
      *p = glm::dvec3(matrix * glm::dvec4(*p, 1.0));
    }
  }
  return scene;
}

/// A turn about no special axis by no special angle: coordinates get all their digits.
inline glm::dmat4 oddRotation()
{
  return glm::rotate(glm::dmat4(1.0), 0.7345, glm::normalize(glm::dvec3(0.3, -0.8, 0.45)));
}

/// A perspective view of about the unit cube.
inline View lookingAt(const glm::dvec3& eye, const glm::dvec3& target, int width, int height,
                      double degrees = 40.0)
{
  const double aspect = static_cast<double>(width) / height;
  const glm::dvec3 up =
      std::abs(glm::normalize(target - eye).z) > 0.99 ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1);
  const double distance = glm::length(target - eye);
  const glm::dmat4 projection =
      glm::perspective(glm::radians(degrees), aspect, 0.01 * distance, 100.0 * distance);
  return {projection * glm::lookAt(eye, target, up), width, height};
}

/// Parallel view straight down: pixel (x, y) sees the world point (x + 0.5, y + 0.5) / scale - half, exactly
/// when scale is a power of two.
inline View lookingDown(int size, double half, double eyeZ)
{
  const glm::dmat4 projection = glm::ortho(-half, half, -half, half, 0.0, 100.0 * half + eyeZ);
  return {projection * glm::translate(glm::dmat4(1.0), glm::dvec3(0.0, 0.0, -eyeZ)), size, size};
}

} // namespace shadow::truth::test
