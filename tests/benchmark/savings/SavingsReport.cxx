#include "SavingsReport.h"

#include <cmath>
#include <cstddef>
#include <iomanip>
#include <ostream>
#include <string>

namespace shadow::benchmarks
{

namespace
{

std::string nameOf(const SavingsRow& row)
{
  return row.scene.name + " / " + namesOfMoves()[static_cast<std::size_t>(row.moves)];
}

/// The most that a row may take, as ratios; 0: nothing is asked.
struct Aim
{
  double ofPlain = 0.0;
  double ofMap = 0.0;
};

Aim aimOf(const SavingsRow& row)
{
  const bool large = row.scene.objects * row.scene.triangles >= 100000;
  switch (row.moves)
  {
    case Moves::Nothing:
      return {1.1, 0.0};
    case Moves::Camera:
      return {row.scene.isMany ? 1.4 : large ? 1.6 : 0.0, large ? 0.0 : 1.0};
    case Moves::Light:
      return {0.0, 0.8};
    case Moves::Actor:
      return {row.scene.isMany ? 1.5 : 0.0, 0.8};
  }
  return {};
}

void printAim(std::ostream& out, const SavingsRow& row, const char* what, double ratio, double most)
{
  if (most > 0.0)
  {
    out << "aim: " << nameOf(row) << ": " << ratio << " of " << what << ", at most " << most << ": "
        << (ratio <= most ? "reached" : "missed") << "\n";
  }
}

/// What each light more takes, of a plain frame with one light, beside what plain VTK takes for it.
void printAimOfLights(std::ostream& out, const std::vector<SavingsRow>& rows)
{
  const SavingsRow* one = nullptr;
  for (const SavingsRow& row : rows)
  {
    const bool isLights = row.scene.name.rfind("lights-", 0) == 0 && row.moves == Moves::Light;
    one = isLights && row.scene.lights == 1 ? &row : one;
    if (isLights && one != nullptr && row.scene.lights > 1)
    {
      const double more = row.scene.lights - one->scene.lights;
      const double ours = (row.all().milliseconds - one->all().milliseconds) / more / one->plain;
      const double plain = (row.plain - one->plain) / more / one->plain;
      out << "aim: " << nameOf(row) << ": " << ours << " of a plain frame for each light more (plain VTK itself "
          << plain << "), at most 0.3: " << (ours <= 0.3 ? "reached" : "missed") << "\n";
    }
  }
}

} // namespace

void printSavingsHead(std::ostream& out)
{
  out << std::left << std::setw(28) << "scene / what moves" << std::right << std::setw(10) << "plain ms"
      << std::setw(8) << "map";
  for (const SavingsDrawer& drawer : savingsDrawers())
  {
    out << std::setw(15) << drawer.name;
  }
  out << std::setw(12) << "all / map" << "    (map and ours: of plain)\n";
}

void printSavings(std::ostream& out, const SavingsRow& row)
{
  out << std::fixed << std::setprecision(2) << std::left << std::setw(28) << nameOf(row) << std::right
      << std::setw(10) << row.plain << std::setw(8) << row.map / row.plain;
  for (const SavingsSample& sample : row.samples)
  {
    out << std::setw(15) << sample.milliseconds / row.plain;
  }
  out << std::setw(12) << row.all().milliseconds / row.map << std::endl; // a long run is watched
}

void printWork(std::ostream& out, const std::vector<SavingsRow>& rows)
{
  out << "\nWork of the last frame\n";
  for (const SavingsRow& row : rows)
  {
    for (std::size_t i = 0; i < row.samples.size(); ++i)
    {
      out << std::left << std::setw(28) << (i == 0 ? nameOf(row) : "") << std::setw(16) << savingsDrawers()[i].name
          << std::right;
      for (const auto& [name, count] : row.samples[i].work)
      {
        out << "  " << name << " " << count;
      }
      out << "\n";
    }
  }
}

void printAims(std::ostream& out, const std::vector<SavingsRow>& rows)
{
  out << "\n";
  for (const SavingsRow& row : rows)
  {
    const Aim aim = aimOf(row);
    printAim(out, row, "plain", row.all().milliseconds / row.plain, aim.ofPlain);
    printAim(out, row, "the shadow map", row.all().milliseconds / row.map, aim.ofMap);
  }
  printAimOfLights(out, rows);
}

void printSavingsTable(std::ostream& out, const std::vector<SavingsRow>& rows)
{
  out << "scene,moves,drawer,objects,triangles,lights,plain_ms,map_ms,ms";
  for (const auto& work : rows.front().all().work)
  {
    out << "," << work.first;
  }
  out << "\n";
  for (const SavingsRow& row : rows)
  {
    for (std::size_t i = 0; i < row.samples.size(); ++i)
    {
      out << row.scene.name << "," << namesOfMoves()[static_cast<std::size_t>(row.moves)] << ","
          << savingsDrawers()[i].name << "," << row.scene.objects << "," << row.scene.triangles << ","
          << row.scene.lights << "," << row.plain << "," << row.map << "," << row.samples[i].milliseconds;
      for (const auto& work : row.samples[i].work)
      {
        out << "," << work.second;
      }
      out << "\n";
    }
  }
}

double fitExponent(const std::vector<std::pair<double, double>>& points)
{
  double sumX = 0.0;
  double sumY = 0.0;
  double sumXX = 0.0;
  double sumXY = 0.0;
  for (const auto& [x, y] : points)
  {
    sumX += std::log(x);
    sumY += std::log(y);
    sumXX += std::log(x) * std::log(x);
    sumXY += std::log(x) * std::log(y);
  }
  const auto count = static_cast<double>(points.size());
  return (count * sumXY - sumX * sumY) / (count * sumXX - sumX * sumX);
}

} // namespace shadow::benchmarks
