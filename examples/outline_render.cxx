// Draws meshes with hidden-line-correct outlines into a PNG file, without a display. See --help.

#include "OutlineOptions.h"
#include "OutlineRun.h"
#include "Program.h"

#include <iostream>

int main(int argc, char* argv[])
{
  using namespace shadow::examples;
  return runProgram("outline_render",
                    [argc, argv]
                    {
                      const OutlineOptions options = parseOutlineOptions(argc, argv);
                      if (!options.help.empty())
                      {
                        std::cout << options.help << std::flush;
                        return;
                      }
                      OutlineRun(options).run();
                    });
}
