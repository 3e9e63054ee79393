#include "TextCheck.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <fstream>
#include <string_view>

#include "PointRange.h"
#include "TextLines.h"

namespace shadow::examples
{
namespace
{

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
    findings.shift = this->range.getShift();
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
    std::array<double, 3> point{};
    for (double& value : point)
    {
      switch (examine(nextWord(line), value))
      {
      case Number::None:
        return "a point needs three numbers";
      case Number::NotFinite:
        return "point " + std::to_string(this->counts[0]) + " is not finite";
      default:
        break;
      }
    }
    this->range.add(point);
    return {};
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
  PointRange range;
};

} // namespace

ObjFindings checkObj(const std::string& file)
{
  return ObjCheck().find(file);
}

} // namespace shadow::examples
