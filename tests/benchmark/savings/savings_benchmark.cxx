// What each saving of vtkShadowVolumePass saves, beside plain VTK and its shadow map. See --help.

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "CostGrowth.h"
#include "GLInUse.h"
#include "OptionValues.h"
#include "SavingsReport.h"
#include "UserError.h"

namespace
{

using namespace shadow::benchmarks;
using shadow::examples::parseChoice;
using shadow::examples::parseInteger;
using shadow::examples::splitText;
using shadow::examples::UserError;

/// The values as written.
struct Texts
{
  std::string scenes;
  std::string moves = "nothing,camera,light,actor";
  std::string rounds = "15";
  std::string size = "640x480";
  std::string scale = "100";
  std::string table;
  std::string plot;
  bool growth = false;
};

std::vector<SavingsSceneSize> allScenes()
{
  using Kind = SavingsSceneSize::Kind;
  using Eye = SavingsSceneSize::Eye;
  return {{"torus-10k", Kind::Tori, 1, 10000, 1, Eye::Above, false},
          {"ten-tori", Kind::Tori, 10, 3600, 1, Eye::Above, false},
          {"spheres-1000", Kind::Spheres, 1000, 96, 1, Eye::Above, true},
          {"city", Kind::City, 900, 12, 1, Eye::Above, true},
          {"street", Kind::City, 900, 12, 1, Eye::Street, true},
          {"parts-100", Kind::Tori, 100, 900, 1, Eye::Above, false},
          {"instances-far", Kind::Spheres, 2000, 24, 1, Eye::Far, true},
          {"torus-1m", Kind::Tori, 1, 1000000, 1, Eye::Above, false},
          {"lights-1", Kind::Tori, 1, 10000, 1, Eye::Above, false},
          {"lights-4", Kind::Tori, 1, 10000, 4, Eye::Above, false},
          {"lights-16", Kind::Tori, 1, 10000, 16, Eye::Above, false},
          {"lights-32", Kind::Tori, 1, 10000, 32, Eye::Above, false}};
}

void declare(CLI::App& app, Texts& texts)
{
  std::string names;
  for (const SavingsSceneSize& scene : allScenes())
  {
    names += (names.empty() ? "" : ",") + scene.name;
  }
  app.add_option("--scenes", texts.scenes, "some of " + names + "; default: all");
  app.add_option("--moves", texts.moves, "some of nothing,camera,light,actor")->capture_default_str();
  app.add_option("--rounds", texts.rounds, "in each of which every drawer has one turn")->capture_default_str();
  app.add_option("--size", texts.size, "window, WxH")->capture_default_str();
  app.add_option("--scale", texts.scale, "percent of objects and triangles, to try it out")->capture_default_str();
  app.add_option("--table", texts.table, "also write all numbers into this CSV file");
  app.add_flag("--growth", texts.growth,
               "in place of scenes: cost against triangles, instances and lights, and the exponents");
  app.add_option("--plot", texts.plot, "with --growth: also draw these into this SVG file");
}

struct Options
{
  std::vector<SavingsSceneSize> scenes;
  std::vector<Moves> moves;
  int rounds = 1;
  int width = 0;
  int height = 0;
  double scale = 1.0;
};

Options understand(const Texts& texts)
{
  Options options;
  std::vector<std::string> names;
  for (const SavingsSceneSize& scene : allScenes())
  {
    names.push_back(scene.name);
  }
  options.scale = 0.01 * parseInteger("--scale", texts.scale, 1, 1000);
  const std::vector<std::string> wanted = texts.scenes.empty() ? names : splitText(texts.scenes, ',');
  for (const std::string& name : wanted)
  {
    SavingsSceneSize scene = allScenes()[parseChoice("--scenes", name, names)];
    scene.objects = std::max(1, static_cast<int>(std::lround(scene.objects * options.scale)));
    scene.triangles = std::max(12, static_cast<int>(std::lround(scene.triangles * options.scale)));
    options.scenes.push_back(scene);
  }
  for (const std::string& name : splitText(texts.moves, ','))
  {
    options.moves.push_back(static_cast<Moves>(parseChoice("--moves", name, namesOfMoves())));
  }
  options.rounds = parseInteger("--rounds", texts.rounds, 1, 1000);
  const shadow::examples::SizeOption size = shadow::examples::parseSize(texts.size);
  options.width = size.width;
  options.height = size.height;
  return options;
}

void printMachine(const Options& options)
{
  std::cout << describeGL() << "Window " << options.width << "x" << options.height
            << "; medians of " << options.rounds << " frames; plain VTK, its shadow map and ours take turns.\n\n";
}

std::ofstream openTable(const std::string& file)
{
  std::ofstream table;
  if (!file.empty())
  {
    table.open(file);
    if (!table)
    {
      throw UserError("--table: cannot write " + file);
    }
  }
  return table;
}

void runScenes(const Options& options, std::ofstream& table)
{
  std::vector<SavingsRow> rows;
  printSavingsHead(std::cout);
  for (const SavingsSceneSize& scene : options.scenes)
  {
    for (const Moves moves : options.moves)
    {
      rows.push_back(measureSavings(scene, moves, options.width, options.height, options.rounds));
      printSavings(std::cout, rows.back());
    }
  }
  printWork(std::cout, rows);
  printAims(std::cout, rows);
  if (table.is_open())
  {
    printSavingsTable(table, rows);
  }
}

void runGrowth(const Options& options, std::ofstream& table, const std::string& plot)
{
  const std::vector<CostGrowth> growths =
      measureGrowth(options.scale, options.width, options.height, options.rounds);
  std::cout << std::fixed << std::setprecision(2);
  table << "against,number,frame_ms,shadows_ms\n";
  for (const CostGrowth& growth : growths)
  {
    std::cout << "against " << growth.against << ": a frame's exponent " << fitExponent(growth.frames)
              << ", that of its shadows " << fitExponent(growth.shadows) << "\n";
    for (std::size_t i = 0; i < growth.frames.size(); ++i)
    {
      std::cout << "  " << std::setw(9) << static_cast<long long>(growth.frames[i].first) << std::setw(10)
                << growth.frames[i].second << " ms" << std::setw(10) << growth.shadows[i].second << " ms\n";
      table << growth.against << "," << growth.frames[i].first << "," << growth.frames[i].second << ","
            << growth.shadows[i].second << "\n";
    }
  }
  if (!plot.empty())
  {
    plotGrowth(growths, plot);
  }
}

} // namespace

int main(int argc, char** argv)
{
  CLI::App app{"What each saving of vtkShadowVolumePass saves, beside plain VTK and vtkShadowMapPass.\n"
               "VTKSHADOW_HEADLESS=egl draws on a GPU without a display."};
  Texts texts;
  declare(app, texts);
  try
  {
    app.parse(argc, argv);
    const Options options = understand(texts);
    std::ofstream table = openTable(texts.table);
    printMachine(options);
    if (texts.growth)
    {
      runGrowth(options, table, texts.plot);
    }
    else
    {
      runScenes(options, table);
    }
    return EXIT_SUCCESS;
  }
  catch (const CLI::ParseError& error)
  {
    return app.exit(error);
  }
  catch (const std::exception& error)
  {
    std::cerr << "bench_savings: " << error.what() << "\n";
    return EXIT_FAILURE;
  }
}
