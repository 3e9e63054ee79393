#include "TextLines.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>

namespace shadow::examples
{

namespace
{

constexpr std::string_view BLANKS = " \t\r\f\v";

/// Where a comment begins: at the start of a line or after a blank, so that a name may hold the sign.
std::size_t findComment(const std::string& line)
{
  std::size_t place = line.find('#');
  while (place != std::string::npos && place > 0 && BLANKS.find(line[place - 1]) == std::string_view::npos)
  {
    place = line.find('#', place + 1);
  }
  return place;
}

} // namespace

std::string_view nextWord(std::string_view& line)
{
  line.remove_prefix(std::min(line.find_first_not_of(BLANKS), line.size()));
  const std::string_view word = line.substr(0, line.find_first_of(BLANKS));
  line.remove_prefix(word.size());
  return word;
}

Number examine(std::string_view word, double& value)
{
  if (word.size() > 1 && word[0] == '+')
  {
    word.remove_prefix(1);
  }
  const auto result = std::from_chars(word.data(), word.data() + word.size(), value);
  if (word.empty() || result.ptr != word.data() + word.size())
  {
    return Number::None;
  }
  if (result.ec == std::errc::result_out_of_range)
  {
    value = std::strtod(std::string(word).c_str(), nullptr); // tells too large from too small
  }
  return std::isfinite(value) ? Number::Finite : Number::NotFinite;
}

/// Takes comment, line end and backslash off. @return whether there was a backslash
bool ObjLines::isGoingOn(std::string& part)
{
  const std::size_t comment = findComment(part);
  if (comment != std::string::npos)
  {
    // VTK leaves out lines that begin with the sign, and no others.
    this->unusual = this->unusual || comment > 0 || part.back() == '\\' || part.find("\\\r") != std::string::npos;
    part.erase(comment);
    return false;
  }
  while (!part.empty() && part.back() == '\r')
  {
    part.pop_back();
  }
  if (part.empty() || part.back() != '\\')
  {
    return false;
  }
  this->unusual = true;
  part.back() = ' ';
  return true;
}

bool ObjLines::next(std::string& line)
{
  line.clear();
  bool any = false;
  for (std::string part; std::getline(this->stream, part);)
  {
    any = true;
    if (++this->number == 1 && part.rfind("\xef\xbb\xbf", 0) == 0)
    {
      this->unusual = true;
      part.erase(0, 3);
    }
    const bool goesOn = this->isGoingOn(part);
    line += part;
    if (!goesOn)
    {
      return true;
    }
  }
  return any;
}

} // namespace shadow::examples
