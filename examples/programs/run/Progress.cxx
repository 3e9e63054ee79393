#include "Progress.h"

#include <iostream>
#include <utility>

#include <unistd.h>

namespace shadow::examples
{

Progress::Progress(std::string name) : program(std::move(name)), terminal(isatty(STDERR_FILENO) != 0) {}

Progress::~Progress()
{
  this->clear();
}

void Progress::show(const std::string& text) const
{
  if (this->terminal)
  {
    std::cerr << "\r\033[K" << this->program << ": " << text << std::flush;
  }
}

void Progress::clear() const
{
  if (this->terminal)
  {
    std::cerr << "\r\033[K" << std::flush;
  }
}

} // namespace shadow::examples
