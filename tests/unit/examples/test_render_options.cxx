#include "RenderOptions.h"
#include "SilhouetteFinder.h"
#include "UserError.h"

#include <gtest/gtest.h>

#include <clocale>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace
{

using namespace shadow::examples;

RenderOptions parse(std::vector<std::string> arguments)
{
  arguments.insert(arguments.begin(), "shadow_render");
  std::vector<const char*> pointers;
  for (const std::string& argument : arguments)
  {
    pointers.push_back(argument.c_str());
  }
  return parseRenderOptions(static_cast<int>(pointers.size()), pointers.data());
}

// What the user reads; empty when the command line is taken.
std::string refusal(const std::vector<std::string>& arguments)
{
  try
  {
    parse(arguments);
    return {};
  }
  catch (const UsageError& error)
  {
    return error.what();
  }
}

bool says(const std::string& message, const std::string& part)
{
  return message.find(part) != std::string::npos && message.find('\n') == std::string::npos;
}

TEST(RenderOptions, NoArguments_Defaults)
{
  const RenderOptions options = parse({});
  EXPECT_TRUE(options.models.empty());
  EXPECT_TRUE(options.floor);
  EXPECT_TRUE(options.lights.empty());
  EXPECT_FALSE(options.camera);
  EXPECT_FALSE(options.parallelScale);
  EXPECT_FALSE(options.frames);
  EXPECT_EQ(options.size.width, 1280);
  EXPECT_EQ(options.size.height, 720);
  EXPECT_EQ(options.output, "shadow.png");
  EXPECT_TRUE(options.mask.empty());
  EXPECT_TRUE(options.report.empty());
  EXPECT_EQ(options.stencilMethod, 0);
  EXPECT_EQ(options.silhouetteMethod, 0);
  EXPECT_EQ(options.compositing, 0);
  EXPECT_EQ(options.samples, 1);
  EXPECT_TRUE(options.help.empty());
}

TEST(RenderOptions, EveryOption_IsTaken)
{
  const RenderOptions options = parse({"a.obj",         "--output",
                                       "o.png",         "--mask=m.png",
                                       "--report",      "r.json",
                                       "--size",        "640x480",
                                       "--camera",      "-1,2,3,0,0,0,0,1,0,45",
                                       "--parallel",    "2.5",
                                       "--floor",       "off",
                                       "--stencil",     "zfail",
                                       "--silhouette",  "hierarchical",
                                       "--compositing", "additive",
                                       "--samples",     "4",
                                       "--frames",      "12",
                                       "b.ply"});
  EXPECT_EQ(options.models, (std::vector<std::string>{"a.obj", "b.ply"}));
  EXPECT_EQ(options.output, "o.png");
  EXPECT_EQ(options.mask, "m.png");
  EXPECT_EQ(options.report, "r.json");
  EXPECT_EQ(options.size.width, 640);
  EXPECT_EQ(options.size.height, 480);
  ASSERT_TRUE(options.camera);
  EXPECT_EQ(options.camera->position, (Vector3{-1.0, 2.0, 3.0}));
  EXPECT_EQ(options.camera->viewAngle, 45.0);
  EXPECT_EQ(options.parallelScale, 2.5);
  EXPECT_FALSE(options.floor);
  EXPECT_EQ(options.stencilMethod, 2);
  EXPECT_EQ(options.silhouetteMethod, 6);
  EXPECT_EQ(options.compositing, 1);
  EXPECT_EQ(options.samples, 4);
  EXPECT_EQ(options.frames, 12);
}

TEST(RenderOptions, LightsBetweenModels_TakeOneValueEach)
{
  const RenderOptions options = parse({"--light", "point:-1,2,+3", "a.obj", "--light", "directional:0,-2,0",
                                       "--light", "spot:0,5,0,0,0,0,30", "b.obj"});
  EXPECT_EQ(options.models, (std::vector<std::string>{"a.obj", "b.obj"}));
  ASSERT_EQ(options.lights.size(), 3u);
  EXPECT_EQ(options.lights[0].kind, LightOption::Kind::Point);
  EXPECT_EQ(options.lights[0].position, (Vector3{-1.0, 2.0, 3.0}));
  EXPECT_EQ(options.lights[1].kind, LightOption::Kind::Directional);
  EXPECT_EQ(options.lights[1].direction, (Vector3{0.0, -1.0, 0.0}));
  EXPECT_EQ(options.lights[2].kind, LightOption::Kind::Spot);
  EXPECT_EQ(options.lights[2].target, (Vector3{0.0, 0.0, 0.0}));
  EXPECT_EQ(options.lights[2].coneAngle, 30.0);
}

TEST(RenderOptions, ThirtyTwoLights_AndNoMore)
{
  std::vector<std::string> arguments;
  for (int i = 0; i < 32; ++i)
  {
    arguments.insert(arguments.end(), {"--light", "point:0,1,0"});
  }
  EXPECT_EQ(parse(arguments).lights.size(), 32u);
  arguments.insert(arguments.end(), {"--light", "point:0,1,0"});
  EXPECT_TRUE(says(refusal(arguments), "at most 32"));
}

TEST(RenderOptions, Help_NamesEveryOption)
{
  const std::string help = parse({"--help"}).help;
  for (const char* option :
       {"MODEL", "--output", "--mask", "--report", "--size", "--light", "--camera", "--parallel", "--floor",
        "--stencil", "--silhouette", "--compositing", "--samples", "--frames"})
  {
    EXPECT_NE(help.find(option), std::string::npos) << option;
  }
}

TEST(RenderOptions, SilhouetteNames_AreTheLibrarys)
{
  const std::vector<std::string>& names = silhouetteNames();
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    EXPECT_EQ(names[i], shadow::toString(static_cast<shadow::SilhouetteMethod>(i)));
    EXPECT_EQ(parse({"--silhouette", names[i]}).silhouetteMethod, static_cast<int>(i));
    EXPECT_NE(parse({"--help"}).help.find(names[i] + ":"), std::string::npos) << names[i];
  }
  EXPECT_THROW(shadow::toString(static_cast<shadow::SilhouetteMethod>(names.size())), std::invalid_argument)
      << "a method has no name on the command line";
}

struct Refused
{
  std::vector<std::string> arguments;
  std::string part; ///< of the message
};

// The name that ctest shows.
void PrintTo(const Refused& refused, std::ostream* stream)
{
  for (const std::string& argument : refused.arguments)
  {
    *stream << (&argument == &refused.arguments.front() ? "" : " ") << argument;
  }
}

class RenderOptionsRefused : public testing::TestWithParam<Refused>
{
};

TEST_P(RenderOptionsRefused, SaysWhy)
{
  const std::string message = refusal(this->GetParam().arguments);
  EXPECT_TRUE(says(message, this->GetParam().part)) << "said: " << message;
}

INSTANTIATE_TEST_SUITE_P(
    Options, RenderOptionsRefused,
    testing::Values(
        Refused{{"--colour", "red"}, "unknown option --colour; allowed: --help, --output"},
        Refused{{"-x"}, "unknown option -x"}, Refused{{"--output"}, "--output"},
        Refused{{"--output", "--mask", "m.png"}, "--output: needs a value"}, Refused{{"--mask="}, "--mask"},
        Refused{{"--floor", "maybe"}, "allowed: off, on"},
        Refused{{"--stencil", "both"}, "auto, zpass, zfail"},
        Refused{{"--silhouette", "gpu"}, "allowed: auto, brute-force, edge-buffer, "},
        Refused{{"--compositing", "add"}, "mask, additive"}, Refused{{"--samples", "0"}, "between 1 and 32"},
        Refused{{"--samples", "33"}, "between 1 and 32"}, Refused{{"--samples", "2.0"}, "whole number"},
        Refused{{"--samples", "99999999999999999999"}, "between 1 and 32"},
        Refused{{"--frames", "0"}, "between 1 and 9999"}, Refused{{"--frames", "-3"}, "between 1 and 9999"},
        Refused{{"--frames", "ten"}, "whole number"}, Refused{{"--parallel", "0"}, "above 0"},
        Refused{{"--parallel", "-1"}, "above 0"}, Refused{{"--parallel", "nan"}, "not finite"},
        Refused{{"--size", "640x480", "--size", "1x1"}, "--size"}));

INSTANTIATE_TEST_SUITE_P(Size, RenderOptionsRefused,
                         testing::Values(Refused{{"--size", "0x480"}, "1 or more"},
                                         Refused{{"--size", "640x0"}, "1 or more"},
                                         Refused{{"--size", "-640x480"}, "1 or more"},
                                         Refused{{"--size", "640"}, "WIDTHxHEIGHT"},
                                         Refused{{"--size", "640x480x3"}, "WIDTHxHEIGHT"},
                                         Refused{{"--size", "640 x480"}, "whole number"},
                                         Refused{{"--size", "640,480"}, "WIDTHxHEIGHT"},
                                         Refused{{"--size", "1e3x480"}, "whole number"}));

INSTANTIATE_TEST_SUITE_P(Light, RenderOptionsRefused,
                         testing::Values(Refused{{"--light", "1,2,3"}, "point:X,Y,Z"},
                                         Refused{{"--light", "area:1,2,3"},
                                                 "allowed: point, directional, spot"},
                                         Refused{{"--light", "point:1,2"}, "has 2 values, not 3"},
                                         Refused{{"--light", "point:1,2,3,4"}, "has 4 values, not 3"},
                                         Refused{{"--light", "point:1,2,"}, "not a number"},
                                         Refused{{"--light", "point:1,2,3m"}, "not a number"},
                                         Refused{{"--light", "point:1,2, 3"}, "not a number"},
                                         Refused{{"--light", "point:0x1,2,3"}, "not a number"},
                                         Refused{{"--light", "point:inf,2,3"}, "not finite"},
                                         Refused{{"--light", "point:1,nan,3"}, "not finite"},
                                         Refused{{"--light", "point:1,2,1e999"}, "range"},
                                         Refused{{"--light", "directional:0,0,0"}, "no direction"},
                                         Refused{{"--light", "spot:1,2,3,1,2,3,20"}, "no direction"},
                                         Refused{{"--light", "spot:1,2,3,0,0,0,0"}, "cone"},
                                         Refused{{"--light", "spot:1,2,3,0,0,0,-5"}, "cone"},
                                         Refused{{"--light", "spot:1,2,3,0,0,0,180.5"}, "cone"},
                                         Refused{{"--light", "--floor", "off"}, "--light"}));

INSTANTIATE_TEST_SUITE_P(Camera, RenderOptionsRefused,
                         testing::Values(Refused{{"--camera", "0,0,1,0,0,0,0,1,0"}, "has 9 values, not 10"},
                                         Refused{{"--camera", "1,1,1,1,1,1,0,1,0,30"}, "no view direction"},
                                         Refused{{"--camera", "0,5,0,0,0,0,0,1,0,30"}, "view-up"},
                                         Refused{{"--camera", "0,5,0,0,0,0,0,-3,0,30"}, "view-up"},
                                         Refused{{"--camera", "0,0,5,0,0,0,0,0,0,30"}, "view-up"},
                                         Refused{{"--camera", "0,0,5,0,0,0,0,1,0,0"}, "view angle"},
                                         Refused{{"--camera", "0,0,5,0,0,0,0,1,0,180"}, "view angle"},
                                         Refused{{"--camera", "0,0,1e308,0,0,-1e308,0,1,0,30"},
                                                 "no view direction"}));

TEST(RenderOptions, DecimalCommaLocale_NumbersStayTheSame)
{
  const char* german = std::setlocale(LC_ALL, "de_DE.UTF-8");
  const RenderOptions options = parse({"--light", "point:1.5,2.25,3", "--parallel", "0.5"});
  std::setlocale(LC_ALL, "C");
  EXPECT_EQ(options.lights.front().position, (Vector3{1.5, 2.25, 3.0})) << (german != nullptr ? german : "C");
  EXPECT_EQ(options.parallelScale, 0.5);
}

} // namespace
