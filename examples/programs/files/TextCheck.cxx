#include "TextCheck.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <string_view>

#include "TextLines.h"

namespace shadow::examples
{
namespace
{

enum class Number
{
  Finite,
  NotFinite,
  None
};

// @param value  the number
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

// Looks through an OBJ file line by line.
class ObjCheck
{
public:
  ObjFindings find(const std::string& file)
  {
    std::ifstream stream(file, std::ios::binary);
    ObjLines lines(stream);
    std::string damage;
    for (std::string line; damage.empty() && lines.next(line);)
    {
      this->number = lines.getNumber();
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
    ObjFindings findings;
    findings.damage = damage.empty() ? damage : "line " + std::to_string(this->number) + ": " + damage;
    findings.unusual = lines.hasUnusual() || this->emptyCornerEnds;
    findings.shift = this->chooseShift();
    return findings;
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
      for (std::string_view word = nextWord(line); !word.empty() && damage.empty();
           word = nextWord(line))
      {
        damage = this->checkCorner(word);
      }
    }
    return damage;
  }

  std::string checkPoint(std::string_view line)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      const std::string_view word = nextWord(line);
      double value = 0.0;
      switch (examine(word, value))
      {
      case Number::None:
        return "a point needs three numbers";
      case Number::NotFinite:
        return "point " + std::to_string(this->counts[0]) + " is not finite";
      default:
        this->lower[i] = std::min(this->lower[i], value);
        this->upper[i] = std::max(this->upper[i], value);
        break;
      }
    }
    return {};
  }

  // None where single precision has steps that nobody sees: a millionth of the size.
  std::array<double, 3> chooseShift() const
  {
    double size = 0.0;
    double magnitude = 0.0;
    for (std::size_t i = 0; i < 3 && this->counts[0] > 0; ++i)
    {
      size = std::max(size, this->upper[i] - this->lower[i]);
      magnitude = std::max({magnitude, std::abs(this->lower[i]), std::abs(this->upper[i])});
    }
    std::array<double, 3> shift = {0.0, 0.0, 0.0};
    for (std::size_t i = 0; i < 3 && magnitude * 0x1p-24 > 1e-6 * size; ++i)
    {
      shift[i] = std::round(0.5 * this->lower[i] + 0.5 * this->upper[i]);
    }
    return shift;
  }

  // "point", "point/texture", "point//normal" or "point/texture/normal"
  std::string checkCorner(std::string_view word)
  {
    this->emptyCornerEnds = this->emptyCornerEnds || word.back() == '/';
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
  bool emptyCornerEnds = false;
  static constexpr double most = std::numeric_limits<double>::max();
  std::array<double, 3> lower = {most, most, most}; ///< of the points
  std::array<double, 3> upper = {-most, -most, -most};
};

// Lines of a PLY file never go on in another.
bool readPlyLine(std::ifstream& stream, std::string& line, std::size_t& number)
{
  const bool read = static_cast<bool>(std::getline(stream, line));
  number += read ? 1 : 0;
  while (!line.empty() && line.back() == '\r')
  {
    line.pop_back();
  }
  return read;
}

} // namespace

ObjFindings checkObj(const std::string& file)
{
  return ObjCheck().find(file);
}

std::string findPlyDamage(const std::string& file)
{
  std::ifstream stream(file, std::ios::binary);
  std::string line;
  std::size_t number = 0;
  bool text = false;
  bool strips = false;
  bool faces = false;
  for (bool header = true; header && readPlyLine(stream, line, number);)
  {
    text = text || line.rfind("format ascii", 0) == 0;
    header = line.rfind("end_header", 0) != 0;
    strips = strips || line.rfind("element tristrips ", 0) == 0;
    faces = faces || line.rfind("element face ", 0) == 0;
  }
  if (strips && !faces)
  {
    return "its triangles are strips (element tristrips), which are not read";
  }
  while (text && readPlyLine(stream, line, number))
  {
    std::string_view rest = line;
    for (std::string_view word = nextWord(rest); !word.empty(); word = nextWord(rest))
    {
      double value = 0.0;
      if (examine(word, value) == Number::None)
      {
        return "line " + std::to_string(number) + ": not a number";
      }
    }
  }
  return {};
}

} // namespace shadow::examples
