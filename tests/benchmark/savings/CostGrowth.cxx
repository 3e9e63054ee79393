#include "CostGrowth.h"

#include <algorithm>
#include <cmath>

#include "SavingsRun.h"

namespace shadow::benchmarks
{

namespace
{

CostGrowth measureAgainst(const std::string& against, const std::vector<int>& values,
                          int SavingsSceneSize::*number, SavingsSceneSize size, int width, int height, int rounds)
{
  CostGrowth growth;
  growth.against = against;
  for (const int value : values)
  {
    size.name = against + "-" + std::to_string(value);
    size.*number = value;
    const SavingsRow row = measureSavings(size, Moves::Light, width, height, rounds);
    growth.frames.emplace_back(value, row.all().milliseconds);
    growth.shadows.emplace_back(value, std::max(row.all().milliseconds - row.plain, 1e-3));
  }
  return growth;
}

std::vector<int> scaled(const std::vector<int>& values, double scale, int least)
{
  std::vector<int> result;
  for (const int value : values)
  {
    const int number = std::max(least, static_cast<int>(std::lround(value * scale)));
    if (result.empty() || number > result.back())
    {
      result.push_back(number);
    }
  }
  if (result.size() == 1)
  {
    result.push_back(2 * result.front());
  }
  return result;
}

} // namespace

std::vector<CostGrowth> measureGrowth(double scale, int width, int height, int rounds)
{
  using Kind = SavingsSceneSize::Kind;
  SavingsSceneSize spheres;
  spheres.kind = Kind::Spheres;
  spheres.triangles = 100;
  return {measureAgainst("triangles", scaled({16000, 64000, 250000, 1000000}, scale, 100),
                         &SavingsSceneSize::triangles, {}, width, height, rounds),
          measureAgainst("instances", scaled({125, 250, 500, 1000, 2000}, scale, 2), &SavingsSceneSize::objects,
                         spheres, width, height, rounds),
          measureAgainst("lights", scaled({1, 2, 4, 8, 16, 32}, scale, 1), &SavingsSceneSize::lights, {}, width,
                         height, rounds)};
}

} // namespace shadow::benchmarks
