#include "ReaderGuard.h"

#include <cstdio>
#include <cstdlib>

#include <fcntl.h>
#include <unistd.h>

namespace shadow::examples
{
namespace
{

// A signal handler may not allocate nor look into objects that change, so what it needs lies here, ready.
std::string lastLine;
int savedStderr = -1;

extern "C" void sayLastWords(int)
{
  const ssize_t written = write(savedStderr, lastLine.data(), lastLine.size());
  static_cast<void>(written);
  _exit(EXIT_FAILURE);
}

} // namespace

ReaderGuard::ReaderGuard(const std::string& lastWords) : stack(64 * 1024, '\0')
{
  lastLine = lastWords + "\n";
  std::fflush(stderr);
  savedStderr = dup(STDERR_FILENO);
  const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (nowhere >= 0)
  {
    dup2(nowhere, STDERR_FILENO);
    close(nowhere);
  }

  stack_t alternative = {};
  alternative.ss_sp = this->stack.data();
  alternative.ss_size = this->stack.size();
  sigaltstack(&alternative, &this->previousStack);

  struct sigaction action = {};
  action.sa_handler = sayLastWords;
  action.sa_flags = SA_ONSTACK;
  for (std::size_t i = 0; i < SIGNALS.size(); ++i)
  {
    sigaction(SIGNALS[i], &action, &this->previousActions[i]);
  }
}

ReaderGuard::~ReaderGuard()
{
  for (std::size_t i = 0; i < SIGNALS.size(); ++i)
  {
    sigaction(SIGNALS[i], &this->previousActions[i], nullptr);
  }
  sigaltstack(&this->previousStack, nullptr);
  std::fflush(stderr);
  if (savedStderr >= 0)
  {
    dup2(savedStderr, STDERR_FILENO);
    close(savedStderr);
    savedStderr = -1;
  }
}

} // namespace shadow::examples
