// Draws random scenes, or scenes from files, in many ways, and holds the shadow masks against the truth by
// ray casting and against each other. Ends with 1 when any is wrong.
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "FuzzRun.h"
#include "MaskPictures.h"
#include "SceneJson.h"

namespace
{

using namespace shadow::fuzz;

/// @return whether it is right
bool runCase(FuzzSession& session, const std::string& fileName, bool writesPictures,
             const std::string& output)
{
  FuzzScene scene = readScene(fileName);
  scene.configs = listEveryConfig();
  const DrawnScene drawn = session.draw(scene);
  const SceneVerdict verdict = judgeMasks(*drawn.truth, drawn.masks);
  std::printf("%s: %s, at most %zu wrong certain pixels in one of %zu masks\n%s", fileName.c_str(),
              verdict.isWrong() ? "wrong" : "right", verdict.getWorst().wrong, verdict.masks.size(),
              verdict.describe().c_str());
  if (writesPictures)
  {
    const std::size_t slash = fileName.find_last_of('/');
    writePictures(drawn, output + "/" + fileName.substr(slash == std::string::npos ? 0 : slash + 1));
  }
  return !verdict.isWrong();
}

bool runCases(const std::vector<std::string>& fileNames, bool writesPictures, const std::string& output)
{
  FuzzSession session;
  bool areRight = true;
  for (const std::string& fileName : fileNames)
  {
    areRight = runCase(session, fileName, writesPictures, output) && areRight;
  }
  return areRight;
}

} // namespace

int main(int argc, char** argv)
{
  CLI::App app{"Random scenes, drawn in many ways and held against ray casting.", "fuzz_shadows"};
  FuzzOptions options;
  std::vector<std::string> fileNames;
  bool keepsSize = false;
  bool writesPictures = false;
  app.add_option("CASE", fileNames, "Draw the scenes of these files by every method, no random ones");
  app.add_option("--scenes", options.scenes, "How many random scenes")->capture_default_str();
  app.add_option("--seed", options.seed, "Another seed, other scenes")->capture_default_str();
  app.add_option("--first", options.first, "Number of the first scene")->capture_default_str();
  app.add_option("--jobs,--threads", options.jobs, "Processes beside each other")
      ->capture_default_str()
      ->check(CLI::Range(1, 256));
  app.add_option("--output", options.output, "Folder for wrong scenes and pictures")
      ->capture_default_str()
      ->check(CLI::ExistingDirectory);
  app.add_flag("--no-shrink", keepsSize, "Write wrong scenes as they are, not made small");
  app.add_flag("--every-method", options.everyMethod, "Draw every random scene by every method");
  app.add_flag("--list", options.lists, "Print right scenes, too");
  app.add_flag("--picture", writesPictures, "Write truth, masks and differences of the given scenes as PNG");
  CLI11_PARSE(app, argc, argv);
  options.shrinks = !keepsSize;
  try
  {
    const bool isRight =
        fileNames.empty() ? runScenes(options) : runCases(fileNames, writesPictures, options.output);
    return isRight ? EXIT_SUCCESS : EXIT_FAILURE;
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "fuzz_shadows: %s\n", error.what());
    return EXIT_FAILURE;
  }
}
