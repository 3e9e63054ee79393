#include "CommandLine.h"

#include "UserError.h"

#include <CLI/CLI.hpp>

#include <algorithm>

namespace shadow::examples
{
namespace
{

std::string allowedOptions(const CLI::App& app)
{
  std::string list;
  for (const CLI::Option* option : app.get_options())
  {
    if (!option->get_lnames().empty())
    {
      list += (list.empty() ? "--" : ", --") + option->get_lnames().front();
    }
  }
  return list;
}

// "--output --mask" has forgotten a value; CLI11 would take the option for it.
void refuseOptionAsValue(const std::string& option, const std::string& value)
{
  if (value.empty() || value.rfind("--", 0) == 0)
  {
    throw UsageError(option + ": needs a value" + (value.empty() ? "" : ", not '" + value + "'"));
  }
}

} // namespace

struct CommandLine::Implementation
{
  Implementation(const CommandLineTexts& wording, RenderOptions& given)
      : app(wording.description, wording.program), options(given)
  {
  }

  void declareScene();
  void declareOutputs(const CommandLineTexts& texts);
  void interpretScene();
  void interpretView();
  void interpretShadows();

  bool isSet(const std::string& option) const
  {
    const CLI::Option* found = this->app.get_option_no_throw(option);
    return found != nullptr && found->count() > 0;
  }

  int choose(const std::string& option, const std::string& text, const std::vector<std::string>& names,
             int fallback) const
  {
    return this->isSet(option) ? static_cast<int>(parseChoice(option, text, names)) : fallback;
  }

  // The values as written.
  struct Texts
  {
    std::vector<std::string> lights;
    std::string size, camera, parallel, floor, stencil, silhouette, compositing, samples, frames;
  };

  CLI::App app;
  RenderOptions& options;
  Texts texts;
};

void CommandLine::Implementation::declareOutputs(const CommandLineTexts& given)
{
  this->app.set_help_flag("--help", "print this and exit");
  this->app.add_option("MODEL", this->options.models,
                       "obj, ply, stl, vtp, vtk, gltf or glb; none: a built-in scene");
  this->options.output = given.output;
  this->app.add_option("--output", this->options.output, "picture, PNG")
      ->type_name("FILE")
      ->default_str(given.output);
  this->app.add_option("--mask", this->options.mask, given.mask)->type_name("FILE");
  this->app.add_option("--report", this->options.report, "settings, statistics and times, JSON")
      ->type_name("FILE");
}

void CommandLine::Implementation::declareScene()
{
  this->app.add_option("--size", this->texts.size, "pixels")->type_name("WxH")->default_str("1280x720");
  this->app
      .add_option("--light", this->texts.lights,
                  "point:X,Y,Z, directional:DX,DY,DZ (the way it travels) or "
                  "spot:X,Y,Z,TX,TY,TZ,CONE (degrees from axis to rim); up to 32 times")
      ->type_name("LIGHT")
      ->allow_extra_args(false);
  this->app
      .add_option("--camera", this->texts.camera,
                  "position, focal point, view-up, vertical view angle in degrees")
      ->type_name("PX,PY,PZ,FX,FY,FZ,UX,UY,UZ,ANGLE");
  this->app.add_option("--parallel", this->texts.parallel, "parallel view; half its height in world units")
      ->type_name("SCALE");
  this->app.add_option("--floor", this->texts.floor, "a floor below the models")
      ->type_name("on|off")
      ->default_str("on");
  this->app
      .add_option("--frames", this->texts.frames,
                  "turn the lights once round the scene in N numbered pictures")
      ->type_name("N");
}

void CommandLine::Implementation::interpretView()
{
  if (this->isSet("--size"))
  {
    this->options.size = parseSize(this->texts.size);
  }
  if (this->isSet("--camera"))
  {
    this->options.camera = parseCamera(this->texts.camera);
  }
  if (this->isSet("--parallel"))
  {
    this->options.parallelScale = parseNumber("--parallel", this->texts.parallel);
    if (*this->options.parallelScale <= 0.0)
    {
      throw UsageError("--parallel: '" + this->texts.parallel + "' is not above 0");
    }
  }
}

void CommandLine::Implementation::interpretScene()
{
  for (const char* option : {"--output", "--mask", "--report"})
  {
    if (this->isSet(option))
    {
      refuseOptionAsValue(option, this->app.get_option(option)->as<std::string>());
    }
  }
  this->interpretView();
  if (this->texts.lights.size() > MAXIMUM_LIGHTS)
  {
    throw UsageError("--light: given " + std::to_string(this->texts.lights.size()) + " times; at most " +
                     std::to_string(MAXIMUM_LIGHTS) + " lights");
  }
  for (const std::string& text : this->texts.lights)
  {
    this->options.lights.push_back(parseLight(text));
  }
  this->options.floor = this->choose("--floor", this->texts.floor, {"off", "on"}, 1) == 1;
}

void CommandLine::Implementation::interpretShadows()
{
  RenderOptions& set = this->options;
  set.stencilMethod = this->choose("--stencil", this->texts.stencil, stencilNames(), set.stencilMethod);
  set.silhouetteMethod =
      this->choose("--silhouette", this->texts.silhouette, silhouetteNames(), set.silhouetteMethod);
  set.compositing =
      this->choose("--compositing", this->texts.compositing, compositingNames(), set.compositing);
  if (this->isSet("--samples"))
  {
    set.samples = parseInteger("--samples", this->texts.samples, 1, 32);
  }
  if (this->isSet("--frames"))
  {
    set.frames = parseInteger("--frames", this->texts.frames, 1, 9999);
  }
}

CommandLine::CommandLine(const CommandLineTexts& texts, RenderOptions& options)
    : implementation(std::make_unique<Implementation>(texts, options))
{
  this->implementation->declareOutputs(texts);
  this->implementation->declareScene();
}

CommandLine::~CommandLine() = default;

void CommandLine::addShadowOptions()
{
  CLI::App& app = this->implementation->app;
  Implementation::Texts& texts = this->implementation->texts;
  app.add_option("--stencil", texts.stencil, "how volumes are counted")
      ->type_name("auto|zpass|zfail")
      ->default_str("auto");
  app.add_option("--silhouette", texts.silhouette, describeSilhouettes())
      ->type_name("METHOD")
      ->default_str("auto");
  app.add_option("--compositing", texts.compositing, "how light and shadow are put together")
      ->type_name("mask|additive")
      ->default_str("mask");
  app.add_option("--samples", texts.samples, "samples a pixel, 1 to 32")->type_name("N")->default_str("1");
}

void CommandLine::addOption(const std::string& option, std::string& value, const std::string& meaning,
                            const std::string& type, const std::string& defaultValue)
{
  CLI::Option* added = this->implementation->app.add_option(option, value, meaning)->type_name(type);
  if (!defaultValue.empty())
  {
    added->default_str(defaultValue);
  }
}

void CommandLine::addFlag(const std::string& option, bool& value, const std::string& meaning)
{
  this->implementation->app.add_flag(option, value, meaning)->disable_flag_override();
}

bool CommandLine::isSet(const std::string& option) const
{
  return this->implementation->isSet(option);
}

bool CommandLine::parse(int argc, const char* const* argv)
{
  CLI::App& app = this->implementation->app;
  try
  {
    app.parse(argc, argv);
  }
  catch (const CLI::CallForHelp&)
  {
    this->implementation->options.help = app.help();
    return false;
  }
  catch (const CLI::ExtrasError& error)
  {
    throw UsageError("unknown option " + app.remaining().front() + "; allowed: " + allowedOptions(app));
  }
  catch (const CLI::ParseError& error)
  {
    std::string message = error.what();
    std::replace(message.begin(), message.end(), '\n', ' ');
    throw UsageError(message);
  }
  this->implementation->interpretScene();
  this->implementation->interpretShadows();
  return true;
}

} // namespace shadow::examples
