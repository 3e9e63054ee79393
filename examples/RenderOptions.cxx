#include "RenderOptions.h"

#include "UserError.h"

#include <CLI/CLI.hpp>

#include <algorithm>

namespace shadow::examples
{
namespace
{

// The values as written. They are turned into numbers here and not by CLI11, whose number parsing follows the
// locale and takes "0x1p3" or trailing text.
struct Texts
{
  std::vector<std::string> lights;
  std::string size, camera, parallel, floor, stencil, silhouette, compositing, samples, frames;
};

struct Method
{
  std::string name;
  std::string meaning;
};

const std::vector<Method>& silhouetteMethods()
{
  static const std::vector<Method> methods = {
      {"auto", "brute-force for small meshes, hierarchical for large ones"},
      {"brute-force", "facing of every triangle, then every edge, on the CPU"},
      {"edge-buffer", "triangles flip bits at their edges"},
      {"triangular", "TA: a set of directed edges in which opposite ones cancel"},
      {"visible-nonvisible", "VnV: edges with one neighbour that faces the light"},
      {"hybrid", "HSD: TA on polygons merged from coplanar triangles"},
      {"hierarchical", "only clusters of triangles that do not face the light as one, on the CPU"},
      {"topology-aware-mesh", "TAM: each triangle compares itself with its neighbours"},
      {"facing-texture", "facing drawn into a texture by the GPU and read back"},
      {"facing-texture-resident", "the same without reading it back"},
      {"vertex-texture", "the state of every edge drawn into a texture by the GPU"},
      {"vertex-extrusion", "every edge a quad, widened by the vertex shader"},
      {"geometry-shader", "triangles with adjacency, extruded by the geometry shader"},
      {"compute", "edges listed by compute shaders and drawn indirectly; needs GL 4.3"}};
  return methods;
}

// One line a method.
std::string describeSilhouetteMethods()
{
  std::string text = "how silhouettes are found; the mask is the same:";
  for (const Method& method : silhouetteMethods())
  {
    text += "\n" + method.name + ": " + method.meaning;
  }
  return text;
}

void declare(CLI::App& app, RenderOptions& options, Texts& texts)
{
  app.add_option("MODEL", options.models, "obj, ply, stl, vtp, vtk, gltf or glb; none: a built-in scene");
  app.add_option("--output", options.output, "picture, PNG")->type_name("FILE")->default_str("shadow.png");
  app.add_option("--mask", options.mask,
                 "shadow mask, 8-bit grey PNG: 255 reached, 0 in shadow; "
                 "one numbered file for each of several lights")
      ->type_name("FILE");
  app.add_option("--report", options.report, "settings, statistics and times, JSON")->type_name("FILE");
  app.add_option("--size", texts.size, "pixels")->type_name("WxH")->default_str("1280x720");
  app.add_option("--light", texts.lights,
                 "point:X,Y,Z, directional:DX,DY,DZ (the way it travels) or "
                 "spot:X,Y,Z,TX,TY,TZ,CONE (degrees from axis to rim); up to 32 times")
      ->type_name("LIGHT")
      ->allow_extra_args(false);
  app.add_option("--camera", texts.camera, "position, focal point, view-up, vertical view angle in degrees")
      ->type_name("PX,PY,PZ,FX,FY,FZ,UX,UY,UZ,ANGLE");
  app.add_option("--parallel", texts.parallel, "parallel view; half its height in world units")
      ->type_name("SCALE");
  app.add_option("--floor", texts.floor, "a floor below the models")->type_name("on|off")->default_str("on");
  app.add_option("--stencil", texts.stencil, "how volumes are counted")
      ->type_name("auto|zpass|zfail")
      ->default_str("auto");
  app.add_option("--silhouette", texts.silhouette, describeSilhouetteMethods())
      ->type_name("METHOD")
      ->default_str("auto");
  app.add_option("--compositing", texts.compositing, "how light and shadow are put together")
      ->type_name("mask|additive")
      ->default_str("mask");
  app.add_option("--samples", texts.samples, "samples a pixel, 1 to 32")->type_name("N")->default_str("1");
  app.add_option("--frames", texts.frames, "turn the lights once round the scene in N numbered pictures")
      ->type_name("N");
}

bool isSet(const CLI::App& app, const std::string& option)
{
  return app.get_option(option)->count() > 0;
}

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

int choose(const CLI::App& app, const std::string& option, const std::string& text,
           const std::vector<std::string>& names, int fallback)
{
  return isSet(app, option) ? static_cast<int>(parseChoice(option, text, names)) : fallback;
}

void interpretView(const CLI::App& app, const Texts& texts, RenderOptions& options)
{
  if (isSet(app, "--size"))
  {
    options.size = parseSize(texts.size);
  }
  if (isSet(app, "--camera"))
  {
    options.camera = parseCamera(texts.camera);
  }
  if (isSet(app, "--parallel"))
  {
    options.parallelScale = parseNumber("--parallel", texts.parallel);
    if (*options.parallelScale <= 0.0)
    {
      throw UsageError("--parallel: '" + texts.parallel + "' is not above 0");
    }
  }
  if (texts.lights.size() > MAXIMUM_LIGHTS)
  {
    throw UsageError("--light: given " + std::to_string(texts.lights.size()) + " times; at most " +
                     std::to_string(MAXIMUM_LIGHTS) + " lights");
  }
  for (const std::string& text : texts.lights)
  {
    options.lights.push_back(parseLight(text));
  }
  options.floor = choose(app, "--floor", texts.floor, {"off", "on"}, 1) == 1;
}

void interpret(const CLI::App& app, const Texts& texts, RenderOptions& options)
{
  for (const char* option : {"--output", "--mask", "--report"})
  {
    if (isSet(app, option))
    {
      refuseOptionAsValue(option, app.get_option(option)->as<std::string>());
    }
  }
  interpretView(app, texts, options);
  options.stencilMethod = choose(app, "--stencil", texts.stencil, stencilNames(), options.stencilMethod);
  options.silhouetteMethod =
      choose(app, "--silhouette", texts.silhouette, silhouetteNames(), options.silhouetteMethod);
  options.compositing =
      choose(app, "--compositing", texts.compositing, compositingNames(), options.compositing);
  if (isSet(app, "--samples"))
  {
    options.samples = parseInteger("--samples", texts.samples, 1, 32);
  }
  if (isSet(app, "--frames"))
  {
    options.frames = parseInteger("--frames", texts.frames, 1, 9999);
  }
}

} // namespace

const std::vector<std::string>& stencilNames()
{
  static const std::vector<std::string> names = {"auto", "zpass", "zfail"};
  return names;
}

const std::vector<std::string>& silhouetteNames()
{
  static const std::vector<std::string> names = []
  {
    std::vector<std::string> list;
    for (const Method& method : silhouetteMethods())
    {
      list.push_back(method.name);
    }
    return list;
  }();
  return names;
}

const std::vector<std::string>& compositingNames()
{
  static const std::vector<std::string> names = {"mask", "additive"};
  return names;
}

RenderOptions parseRenderOptions(int argc, const char* const* argv)
{
  RenderOptions options;
  Texts texts;
  CLI::App app("Draws meshes with exact hard shadows into a PNG file, without a display.", "shadow_render");
  app.set_help_flag("--help", "print this and exit");
  declare(app, options, texts);
  try
  {
    app.parse(argc, argv);
  }
  catch (const CLI::CallForHelp&)
  {
    options.help = app.help();
    return options;
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
  interpret(app, texts, options);
  return options;
}

} // namespace shadow::examples
