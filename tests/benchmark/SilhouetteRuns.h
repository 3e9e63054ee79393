#pragma once

#include <cmath>
#include <cstddef>
#include <cstring>
#include <memory>
#include <utility>
#include <vector>

#include <benchmark/benchmark.h>

#include <glm/glm.hpp>

#include "SilhouetteFinder.h"
#include "Timing.h"

namespace shadow::benchmarks
{

/// Around the mesh, from run to run elsewhere: close above it, or a direction.
class MovingLight
{
public:
  MovingLight(const SEDGeometry& geometry, bool isDirectional)
      : centre(0.5 * (geometry.getLowerBound() + geometry.getUpperBound())),
        half(0.5 * (geometry.getUpperBound() - geometry.getLowerBound())), directional(isDirectional)
  {
  }

  glm::dvec4 move()
  {
    this->angle += 0.1;
    const glm::dvec3 around(std::cos(this->angle), std::sin(this->angle), 1.25);
    return this->directional
               ? glm::dvec4(around, 0.0)
               : glm::dvec4(this->centre + glm::dvec3(0.4, 0.4, 1.0) * around * this->half, 1.0);
  }

private:
  glm::dvec3 centre;
  glm::dvec3 half;
  bool directional;
  double angle = 0.0;
};

/// One method on one mesh, in memory that it has used before.
class Run
{
public:
  Run(const SEDGeometry& theGeometry, SilhouetteMethod method, ParallelFor parallelFor = {})
      : geometry(theGeometry), finder(makeSilhouetteFinder(method, 0.0, std::move(parallelFor)))
  {
  }

  double measureOnce(const glm::dvec4& lightMC)
  {
    this->milliseconds.push_back(measure([&] { this->find(lightMC); }));
    return this->milliseconds.back();
  }

  void find(const glm::dvec4& lightMC)
  {
    this->finder->face(this->geometry, lightMC, this->facing);
    const auto edges =
        this->finder->find(this->geometry, this->facing, chooseCasting(this->geometry, lightMC));
    this->edgeCount = edges.size();
    benchmark::DoNotOptimize(edges.data());
  }

  double getMedian() const { return median(this->milliseconds); }
  std::size_t countEdges() const { return this->edgeCount; }

private:
  const SEDGeometry& geometry;
  std::unique_ptr<SilhouetteFinder> finder;
  LightFacing facing;
  std::vector<double> milliseconds;
  std::size_t edgeCount = 0;
};

/// Copies as much memory as brings the bytes read and written to a given number.
class MemoryCopy
{
public:
  explicit MemoryCopy(std::size_t bytes) : from(bytes / 2, 1), to(bytes / 2, 2) {}

  void measureOnce()
  {
    this->milliseconds.push_back(
        measure([&] { std::memcpy(this->to.data(), this->from.data(), this->from.size()); }));
    benchmark::DoNotOptimize(this->to.data());
  }

  double getMedian() const { return median(this->milliseconds); }
  double getBytesPerSecond() const
  {
    return 2e3 * static_cast<double>(this->from.size()) / this->getMedian();
  }

private:
  std::vector<char> from;
  std::vector<char> to;
  std::vector<double> milliseconds;
};

} // namespace shadow::benchmarks
