#include "TextCheck.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <string_view>

namespace shadow::examples
{
namespace
{

constexpr std::string_view BLANKS = " \t\r\f\v";

// Takes the next word off the front; empty at the end.
std::string_view nextWord(std::string_view& line)
{
  line.remove_prefix(std::min(line.find_first_not_of(BLANKS), line.size()));
  const std::string_view word = line.substr(0, line.find_first_of(BLANKS));
  line.remove_prefix(word.size());
  return word;
}

enum class Number
{
  Finite,
  NotFinite,
  None
};

Number examine(std::string_view word)
{
  if (word.size() > 1 && word[0] == '+')
  {
    word.remove_prefix(1);
  }
  double value = 0.0;
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

// A line of the file with those that it goes on in after a backslash; its number is that of the last.
bool readLine(std::ifstream& stream, std::string& line, std::size_t& number)
{
  line.clear();
  for (std::string part; std::getline(stream, part);)
  {
    ++number;
    line += part;
    while (!line.empty() && line.back() == '\r')
    {
      line.pop_back();
    }
    if (line.empty() || line.back() != '\\')
    {
      return true;
    }
    line.back() = ' ';
  }
  return !line.empty();
}

// Looks through an OBJ file line by line.
class ObjCheck
{
public:
  std::string find(const std::string& file)
  {
    std::ifstream stream(file, std::ios::binary);
    std::string damage;
    for (std::string line; damage.empty() && readLine(stream, line, this->number);)
    {
      damage = this->checkLine(line);
    }
    for (std::size_t kind = 0; damage.empty() && kind < this->largest.size(); ++kind)
    {
      if (this->largest[kind].index > this->counts[kind])
      {
        this->number = this->largest[kind].line;
        damage = this->missing(kind);
      }
    }
    return damage.empty() ? damage : "line " + std::to_string(this->number) + ": " + damage;
  }

private:
  // A face may use points that come later, so the largest index waits for the end of the file.
  struct Use
  {
    long long index = 0;
    std::size_t line = 0;
  };

  std::string checkLine(std::string_view line)
  {
    const std::string_view key = nextWord(line);
    if (key == "v")
    {
      ++this->counts[0];
      return this->checkPoint(line);
    }
    this->counts[1] += key == "vt" ? 1 : 0;
    this->counts[2] += key == "vn" ? 1 : 0;
    std::string damage;
    if (key == "f")
    {
      for (std::string_view word = nextWord(line); !word.empty() && word[0] != '#' && damage.empty();
           word = nextWord(line))
      {
        damage = this->checkCorner(word);
      }
    }
    return damage;
  }

  std::string checkPoint(std::string_view line) const
  {
    for (int i = 0; i < 3; ++i)
    {
      const std::string_view word = nextWord(line);
      switch (examine(word))
      {
      case Number::None:
        return "a point needs three numbers";
      case Number::NotFinite:
        return "point " + std::to_string(this->counts[0]) + " is not finite";
      default:
        break;
      }
    }
    return {};
  }

  // "point", "point/texture", "point//normal" or "point/texture/normal"
  std::string checkCorner(std::string_view word)
  {
    for (std::size_t kind = 0; kind < 3 && !word.empty(); ++kind)
    {
      const std::string_view text = word.substr(0, word.find('/'));
      word.remove_prefix(std::min(text.size() + 1, word.size()));
      if (text.empty() && kind > 0)
      {
        continue;
      }
      long long index = 0;
      const auto result = std::from_chars(text.data(), text.data() + text.size(), index);
      if (result.ec != std::errc() || result.ptr != text.data() + text.size())
      {
        return "a face has a corner that is no number";
      }
      if (index == 0 || index < -this->counts[kind])
      {
        return missing(kind);
      }
      if (index > this->largest[kind].index)
      {
        this->largest[kind] = {index, this->number};
      }
    }
    return {};
  }

  static std::string missing(std::size_t kind)
  {
    constexpr std::array<const char*, 3> names = {"point", "texture coordinate", "normal"};
    return std::string("a face uses a ") + names[kind] + " that does not exist";
  }

  std::array<long long, 3> counts = {0, 0, 0}; ///< so far: points, texture coordinates, normals
  std::array<Use, 3> largest;
  std::size_t number = 0; ///< of the line
};

} // namespace

std::string findObjDamage(const std::string& file)
{
  return ObjCheck().find(file);
}

std::string findPlyDamage(const std::string& file)
{
  std::ifstream stream(file, std::ios::binary);
  std::string line;
  std::size_t number = 0;
  bool text = false;
  for (bool header = true; header && readLine(stream, line, number);)
  {
    text = text || line.rfind("format ascii", 0) == 0;
    header = line.rfind("end_header", 0) != 0;
  }
  while (text && readLine(stream, line, number))
  {
    std::string_view rest = line;
    for (std::string_view word = nextWord(rest); !word.empty(); word = nextWord(rest))
    {
      if (examine(word) == Number::None)
      {
        return "line " + std::to_string(number) + ": not a number";
      }
    }
  }
  return {};
}

} // namespace shadow::examples
