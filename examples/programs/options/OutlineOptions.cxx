#include "OutlineOptions.h"

#include "CommandLine.h"
#include "UserError.h"

namespace shadow::examples
{
namespace
{

// The values as written.
struct Texts
{
  std::string width, colour, crease;
};

double parseBetween(const std::string& option, const std::string& text, double lowest, double highest,
                    const std::string& range)
{
  const double value = parseNumber(option, text);
  if (value < lowest || value > highest)
  {
    throw UsageError(option + ": '" + text + "' is not " + range);
  }
  return value;
}

void interpret(const CommandLine& commandLine, const Texts& texts, OutlineOptions& options)
{
  if (commandLine.isSet("--width"))
  {
    options.width = parseBetween("--width", texts.width, 0.5, 64.0, "from 0.5 to 64");
  }
  if (commandLine.isSet("--colour"))
  {
    const std::vector<double> parts = parseNumbers("--colour", texts.colour, 3);
    for (std::size_t i = 0; i < 3; ++i)
    {
      if (parts[i] < 0.0 || parts[i] > 1.0)
      {
        throw UsageError("--colour: red, green and blue in '" + texts.colour + "' are not all from 0 to 1");
      }
      options.colour[i] = parts[i];
    }
  }
  if (commandLine.isSet("--crease"))
  {
    options.creaseDegrees = parseBetween("--crease", texts.crease, 0.0, 180.0, "from 0 to 180 degrees");
  }
  for (const char* option : {"--stencil", "--silhouette", "--compositing", "--samples"})
  {
    if (commandLine.isSet(option) && !options.withShadows)
    {
      throw UsageError(std::string(option) + ": is about shadows, and needs --with-shadows");
    }
  }
}

} // namespace

OutlineOptions parseOutlineOptions(int argc, const char* const* argv)
{
  OutlineOptions options;
  Texts texts;
  CommandLine commandLine(
      {"outline_render", "Draws meshes with their outlines into a PNG file, without a display.",
       "outline.png", "line mask, 8-bit grey PNG: 255 line, 0 elsewhere; what is hidden is not in it"},
      options);
  commandLine.addOption("--width", texts.width, "of the lines, in pixels", "PX", "2");
  commandLine.addOption("--colour", texts.colour, "of the lines, each from 0 to 1", "R,G,B", "0,0,0");
  commandLine.addOption("--crease", texts.crease,
                        "also edges whose triangles' normals are more than so many degrees apart", "DEGREES",
                        "");
  commandLine.addFlag("--hidden", options.hidden, "draw hidden lines faintly");
  commandLine.addFlag("--with-shadows", options.withShadows, "exact hard shadows below the lines");
  commandLine.addShadowOptions();
  if (commandLine.parse(argc, argv))
  {
    interpret(commandLine, texts, options);
  }
  return options;
}

} // namespace shadow::examples
