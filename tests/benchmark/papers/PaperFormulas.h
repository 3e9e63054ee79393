#pragma once

#include "PublishedForms.h"

/// Operation counts as Kolivand & Sunar 2011 print them in chapter 6. They take n for the number of faces,
/// 6 n for that of edges, and m sides a face.
namespace shadow::benchmarks
{

inline Operations paperTriangular(double n, double m)
{
  return {8 * n, (m + 10) * n, 6 * n * n * m, 6 * n * n * m + m * n + 8 * n, 2 * m * n};
}

inline Operations paperVisibleNonVisible(double n, double)
{
  return {54 * n * n, 60 * n * n, 6 * n * n + 6 * n, 48 * n * n + 6 * n, 6 * n};
}

inline Operations paperHybrid(double n, double)
{
  return {8 * n, 11 * n, 6 * n * n + n, 6 * n * n + 9 * n, 2 * n};
}

/// Frames a second with a bunny of 2,207 edges, on a Pentium IV at 2.8 GHz. "Conventional" stands for TA and
/// VnV without saying which; the introduction has the first figure, chapter VIII the second.
constexpr double paperHybridFrames = 75.53;
constexpr double paperConventionalFramesIntroduction = 69.93;
constexpr double paperConventionalFramesResults = 67.54;

} // namespace shadow::benchmarks
