// Draws meshes with exact hard shadows into a PNG file, without a display. See --help.

#include "RenderOptions.h"
#include "ShadowRun.h"
#include "UserError.h"

#include <csignal>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <new>
#include <string>

namespace
{

constexpr int EXIT_USAGE = 2;

int fail(const std::string& message, int code)
{
  std::cerr << "shadow_render: " << message << std::endl;
  return code;
}

} // namespace

int main(int argc, char* argv[])
{
  using namespace shadow::examples;
  std::signal(SIGXFSZ, SIG_IGN); // a file that grows over the user's limit is a failed write, not the end
  try
  {
    const RenderOptions options = parseRenderOptions(argc, argv);
    if (!options.help.empty())
    {
      std::cout << options.help << std::flush;
      return EXIT_SUCCESS;
    }
    ShadowRun(options).run();
    return EXIT_SUCCESS;
  }
  catch (const UsageError& error)
  {
    return fail(error.what(), EXIT_USAGE);
  }
  catch (const std::bad_alloc&)
  {
    return fail("there is not enough memory", EXIT_FAILURE);
  }
  catch (const std::exception& error)
  {
    return fail(error.what(), EXIT_FAILURE);
  }
}
