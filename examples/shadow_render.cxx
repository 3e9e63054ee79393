// Draws meshes with exact hard shadows into a PNG file, without a display. See --help.

#include "Program.h"
#include "RenderOptions.h"
#include "ShadowRun.h"

#include <iostream>

int main(int argc, char* argv[])
{
  using namespace shadow::examples;
  return runProgram("shadow_render",
                    [argc, argv]
                    {
                      const RenderOptions options = parseRenderOptions(argc, argv);
                      if (!options.help.empty())
                      {
                        std::cout << options.help << std::flush;
                        return;
                      }
                      ShadowRun(options).run();
                    });
}
