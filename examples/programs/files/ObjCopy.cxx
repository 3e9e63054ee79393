#include "ObjCopy.h"

#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <limits>
#include <string_view>

#include "TextLines.h"

namespace shadow::examples
{

namespace
{

void copyPoint(std::string_view rest, const std::array<double, 3>& shift, std::ostream& copy)
{
  copy << 'v';
  for (const double by : shift)
  {
    copy << ' ' << std::strtod(std::string(nextWord(rest)).c_str(), nullptr) - by;
  }
  copy << rest << '\n';
}

/// "1//" and "1/" are "1".
void copyCorners(std::string_view key, std::string_view rest, std::ostream& copy)
{
  copy << key;
  for (std::string_view word = nextWord(rest); !word.empty(); word = nextWord(rest))
  {
    copy << ' ' << word.substr(0, word.find_last_not_of('/') + 1);
  }
  copy << '\n';
}

} // namespace

ObjCopy::ObjCopy(const std::string& file, const std::array<double, 3>& shift)
    : TemporaryModel(".obj")
{
  std::ifstream original(file, std::ios::binary);
  std::ostream& copy = this->getStream();
  copy << std::setprecision(std::numeric_limits<double>::max_digits10);
  ObjLines lines(original);
  for (std::string line; lines.next(line);)
  {
    std::string_view rest = line;
    const std::string_view key = nextWord(rest);
    if (key == "v")
    {
      copyPoint(rest, shift, copy);
    }
    else if (key == "f" || key == "l")
    {
      copyCorners(key, rest, copy);
    }
    else if (!key.empty())
    {
      copy << key << rest << '\n';
    }
  }
  this->finish();
}

} // namespace shadow::examples
