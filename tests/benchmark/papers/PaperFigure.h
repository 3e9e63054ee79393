#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "FigureMeasurement.h"

namespace shadow::benchmarks
{

/// A figure of a paper: frames a second against one number.
struct PaperFigure
{
  enum class Against
  {
    Triangles,
    Lights
  };

  /// A row's frames a second relative to brute-force, as the paper has it.
  struct PaperRatio
  {
    std::string method;
    std::string text;
  };

  std::string name;  ///< on the command line
  std::string title; ///< paper and numbers
  std::string scene; ///< what the paper says of it, and what it leaves open
  Against against = Against::Triangles;
  SceneSize size; ///< where it does not vary
  std::vector<PaperRatio> zPassRatios;
  std::vector<PaperRatio> zFailRatios;
};

/// Shi 2006, figures 5.1 and 5.2 (one on the CPU, one on the GPU), 5.3 and 5.4; Zerari & Babahenini 2011,
/// figure 6.
const std::vector<PaperFigure>& paperFigures();

/// One point of a figure: the number it stands at, and a sample for each method.
struct FigurePoint
{
  int value = 0;
  std::vector<FigureSample> samples;
};

/// Everything that was measured of a figure with one way of counting.
struct MeasuredFigure
{
  const PaperFigure* figure = nullptr;
  bool zFail = false;
  std::vector<FigureMethod> methods;
  std::vector<FigurePoint> points;
};

/// Frames a second with their ratio to brute-force and the paper's beside; what reading back takes; the
/// stages at the last point; and what was not drawn as asked.
///
/// @pre the methods have brute-force among them
void printFigure(std::ostream& out, const MeasuredFigure& measured);

/// A line for each point and method; the names of the columns come from printTableHead().
void printTable(std::ostream& out, const MeasuredFigure& measured);
void printTableHead(std::ostream& out);

} // namespace shadow::benchmarks
