// The papers' figures drawn again: frames a second against triangles and against lights, for every silhouette
// method, z-pass and z-fail, everything rebuilt each frame. See --help.

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "GLInUse.h"
#include "OptionValues.h"
#include "PaperFigure.h"
#include "UserError.h"

namespace
{

using namespace shadow::benchmarks;
using shadow::examples::parseChoice;
using shadow::examples::parseInteger;
using shadow::examples::splitText;
using shadow::examples::UserError;

struct Options
{
  std::vector<const PaperFigure*> figures;
  std::vector<FigureMethod> methods;
  std::vector<bool> zFail;
  std::vector<int> triangles;
  std::vector<int> lights;
  FigureEffort effort;
  int width = 0;
  int height = 0;
  bool additive = true;
  std::string table;
};

/// The values as written.
struct Texts
{
  std::string figures = "shi-triangles,shi-lights,zerari";
  std::string methods;
  std::string stencil = "zpass,zfail";
  std::string triangles;
  std::string lights;
  std::string rounds;
  std::string frames = "3";
  std::string size;
  std::string compositing = "additive";
  std::string table;
  bool quick = false;
};

void declare(CLI::App& app, Texts& texts)
{
  app.add_option("--figures", texts.figures, "some of shi-triangles,shi-lights,zerari")
      ->capture_default_str();
  app.add_option("--methods", texts.methods,
                 "some of the silhouette methods, besides brute-force; default: all");
  app.add_option("--stencil", texts.stencil, "some of zpass,zfail")->capture_default_str();
  app.add_option("--triangles", texts.triangles, "points of the figures against triangles");
  app.add_option("--lights", texts.lights, "points of the figure against lights, up to 32");
  app.add_option("--rounds", texts.rounds, "in each of which every method has one turn (7, quick 2)");
  app.add_option("--frames", texts.frames, "timed frames of a turn")->capture_default_str();
  app.add_option("--size", texts.size, "window, WxH (640x480, quick 320x240)");
  app.add_option("--compositing", texts.compositing, "mask, or the papers' additive")->capture_default_str();
  app.add_option("--table", texts.table, "also write all numbers into this CSV file");
  app.add_flag("--quick", texts.quick, "two points a figure, a small window, 2 rounds: under a minute");
}

std::vector<int> parsePoints(const std::string& option, const std::string& text, int lowest, int highest)
{
  std::vector<int> points;
  for (const std::string& part : splitText(text, ','))
  {
    points.push_back(parseInteger(option, part, lowest, highest));
  }
  return points;
}

std::vector<FigureMethod> chooseMethods(const std::string& text)
{
  std::vector<FigureMethod> all = allFigureMethods();
  if (text.empty())
  {
    return all;
  }
  std::vector<std::string> names;
  std::transform(all.begin(), all.end(), std::back_inserter(names),
                 [](const FigureMethod& method) { return method.name; });
  std::vector<bool> wanted(all.size(), false);
  for (const std::string& name : splitText(text, ','))
  {
    wanted[parseChoice("--methods", name, names)] = true;
  }
  std::vector<FigureMethod> methods;
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    // What ratios relate to is always there.
    if (wanted[i] || all[i].name == "brute-force")
    {
      methods.push_back(all[i]);
    }
  }
  return methods;
}

Options understand(const Texts& texts)
{
  Options options;
  std::vector<std::string> figureNames;
  for (const PaperFigure& figure : paperFigures())
  {
    figureNames.push_back(figure.name);
  }
  for (const std::string& name : splitText(texts.figures, ','))
  {
    options.figures.push_back(&paperFigures()[parseChoice("--figures", name, figureNames)]);
  }
  for (const std::string& name : splitText(texts.stencil, ','))
  {
    options.zFail.push_back(parseChoice("--stencil", name, {"zpass", "zfail"}) == 1);
  }
  const auto orDefault = [&](const std::string& text, const char* all, const char* quick) {
    return !text.empty() ? text : texts.quick ? quick : all;
  };
  options.methods = chooseMethods(texts.methods);
  options.triangles =
      parsePoints("--triangles", orDefault(texts.triangles, "1000,2500,5000,10000,25000,50000", "1000,5000"),
                  100, 10000000);
  options.lights = parsePoints("--lights", orDefault(texts.lights, "1,2,3,4,6,8", "1,4"), 1, 32);
  options.effort.rounds = parseInteger("--rounds", orDefault(texts.rounds, "7", "2"), 1, 1000);
  options.effort.frames = parseInteger("--frames", texts.frames, 1, 1000);
  const shadow::examples::SizeOption size =
      shadow::examples::parseSize(orDefault(texts.size, "640x480", "320x240"));
  options.width = size.width;
  options.height = size.height;
  options.additive = parseChoice("--compositing", texts.compositing, {"mask", "additive"}) == 1;
  options.table = texts.table;
  return options;
}

/// What draws, and what the numbers are worth.
void printMachine(std::ostream& out, const Options& options)
{
  out << describeGL() << "Window " << options.width << "x" << options.height << ", "
      << (options.additive ? "an ambient pass and a lighting pass for each light"
                           : "one lighting pass with the mask of all lights")
      << "; lights move, everything is rebuilt each frame.\nMedians of " << options.effort.rounds << " x "
      << options.effort.frames << " frames; methods take turns.\n";
}

MeasuredFigure measure(const PaperFigure& figure, bool zFail, const Options& options)
{
  MeasuredFigure measured{&figure, zFail, options.methods, {}};
  const bool lights = figure.against == PaperFigure::Against::Lights;
  for (const int value : lights ? options.lights : options.triangles)
  {
    std::cerr << figure.name << (zFail ? " z-fail " : " z-pass ") << value << " ...\n";
    SceneSize size = figure.size;
    (lights ? size.lights : size.triangles) = value;
    size.width = options.width;
    size.height = options.height;
    FigureScene scene(size);
    if (options.additive)
    {
      scene.scene.pass->SetCompositingToAdditive();
    }
    const int stencil = zFail ? vtkShadowVolumePass::STENCIL_ZFAIL : vtkShadowVolumePass::STENCIL_ZPASS;
    measured.points.push_back({value, measureFigurePoint(scene, options.methods, stencil, options.effort)});
  }
  return measured;
}

void run(const Options& options)
{
  printMachine(std::cout, options);
  std::ofstream table;
  if (!options.table.empty())
  {
    table.open(options.table);
    printTableHead(table);
    if (!table)
    {
      throw UserError("--table: cannot write " + options.table);
    }
  }
  for (const PaperFigure* figure : options.figures)
  {
    for (const bool zFail : options.zFail)
    {
      const MeasuredFigure measured = measure(*figure, zFail, options);
      printFigure(std::cout, measured);
      if (table.is_open())
      {
        printTable(table, measured);
      }
    }
  }
}

} // namespace

int main(int argc, char** argv)
{
  CLI::App app{"Frames a second against triangles and lights: the figures of Shi 2006 and of Zerari & "
               "Babahenini 2011.\n"
               "VTKSHADOW_HEADLESS=egl draws on a GPU without a display."};
  Texts texts;
  declare(app, texts);
  try
  {
    app.parse(argc, argv);
    run(understand(texts));
    return EXIT_SUCCESS;
  }
  catch (const CLI::ParseError& error)
  {
    return app.exit(error);
  }
  catch (const std::exception& error)
  {
    std::cerr << "bench_papers: " << error.what() << "\n";
    return EXIT_FAILURE;
  }
}
