#include "Program.h"

#include "UserError.h"

#include <csignal>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <new>

namespace shadow::examples
{
namespace
{

constexpr int EXIT_USAGE = 2;

} // namespace

int runProgram(const std::string& program, const std::function<void()>& work)
{
  const auto fail = [&program](const std::string& message, int code)
  {
    std::cerr << program << ": " << message << std::endl;
    return code;
  };
  std::signal(SIGXFSZ, SIG_IGN); // a file that grows over the user's limit is a failed write, not the end
  try
  {
    work();
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

} // namespace shadow::examples
