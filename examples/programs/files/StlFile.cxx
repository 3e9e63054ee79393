#include "StlFile.h"

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <limits>
#include <string_view>

#include "PointRange.h"
#include "StlGrammar.h"
#include "TextLines.h"
#include "UserError.h"

namespace shadow::examples
{

namespace
{

constexpr std::string_view byteOrderMark = "\xef\xbb\xbf";

/// vtkSTLReader has lines of 256 characters.
constexpr std::size_t longestLine = 250;

std::string_view withoutMark(std::string_view line)
{
  return line.substr(line.rfind(byteOrderMark, 0) == 0 ? byteOrderMark.size() : 0);
}

/// What stands before the line that begins with "solid": a mark, comments, empty lines.
struct Opening
{
  bool text = false;
  bool plain = true; ///< nothing, and that line as vtkSTLReader wants it from VTK 9.6 on
};

// A text STL begins with "solid", and so do the headers of some binary ones; those have a zero byte in their
// count, and in what follows.
Opening readOpening(std::istream& stream)
{
  Opening opening;
  std::string line;
  constexpr int mostLines = 100;
  for (int number = 0; number < mostLines && std::getline(stream, line); ++number)
  {
    if (line.find('\0') != std::string::npos)
    {
      return {};
    }
    if (number == 0 && line.rfind(byteOrderMark, 0) == 0)
    {
      opening.plain = false;
      line.erase(0, byteOrderMark.size());
    }
    const std::string word = getStlWord(line);
    if (word == "solid")
    {
      opening.text = true;
      opening.plain = opening.plain && line.rfind("solid", 0) == 0;
      return opening;
    }
    if (!isStlComment(word))
    {
      return {};
    }
    opening.plain = false;
  }
  return {};
}

struct TextFindings
{
  bool unusual = false; ///< lines as vtkSTLReader does not want them
  PointRange range;
};

TextFindings lookThrough(std::istream& stream)
{
  StlGrammar grammar;
  bool longLine = false;
  for (std::string line; std::getline(stream, line);)
  {
    longLine = longLine || line.size() > longestLine;
    grammar.take(withoutMark(line));
  }
  grammar.finish();
  return {longLine || grammar.hasComments(), grammar.getRange()};
}

void copyPoint(std::string_view rest, const std::array<double, 3>& shift, std::ostream& copy)
{
  copy << "vertex";
  for (const double offset : shift)
  {
    double value = 0.0;
    examine(nextWord(rest), value);
    copy << ' ' << value - offset;
  }
  copy << '\n';
}

std::unique_ptr<TemporaryModel> copyPlainly(std::istream& stream, const std::array<double, 3>& shift)
{
  auto copy = std::make_unique<TemporaryModel>(".stl");
  copy->getStream() << std::setprecision(std::numeric_limits<double>::max_digits10);
  for (std::string line; std::getline(stream, line);)
  {
    std::string_view rest = withoutMark(line);
    const std::string word = getStlWord(rest);
    if (word == "vertex")
    {
      nextWord(rest);
      copyPoint(rest, shift, copy->getStream());
    }
    else if (!isStlComment(word))
    {
      const bool named = word == "solid" || word == "endsolid";
      copy->getStream() << (named ? word + " model" : line) << '\n';
    }
  }
  copy->finish();
  return copy;
}

PointRange readBinaryRange(std::istream& stream, std::uint64_t count)
{
  PointRange range;
  std::array<char, 50> facet{}; // a normal, three points, two bytes
  for (std::uint64_t i = 0; i < count && stream.read(facet.data(), facet.size()); ++i)
  {
    for (std::size_t place = 12; place < 48; place += 12)
    {
      std::array<float, 3> point{};
      std::memcpy(point.data(), facet.data() + place, sizeof(point));
      range.add({point[0], point[1], point[2]});
    }
  }
  return range;
}

// vtkSTLReader reads to the end of the file whatever the header says, so a file that was cut off or is no STL
// at all would become a mesh of random triangles.
void checkBinary(const std::string& file, std::istream& stream, std::vector<std::string>& warnings)
{
  constexpr std::size_t headerSize = 84; // 80 bytes of text and the number of triangles
  std::string header(headerSize, ' ');
  stream.read(header.data(), headerSize);
  if (static_cast<std::size_t>(stream.gcount()) != headerSize)
  {
    return;
  }
  std::uint64_t count = 0;
  for (std::size_t i = headerSize; i-- > headerSize - 4;)
  {
    count = count * 256 + static_cast<unsigned char>(header[i]);
  }
  if (std::filesystem::file_size(file) != headerSize + 50 * count)
  {
    throw UserError("cannot be read: neither text nor as long as its header says");
  }
  const std::string warning = readBinaryRange(stream, count).describeStep();
  if (!warning.empty())
  {
    warnings.push_back(warning);
  }
}

} // namespace

StlFindings checkStl(const std::string& file, std::vector<std::string>& warnings)
{
  std::ifstream stream(file, std::ios::binary);
  const auto rewind = [&stream]
  {
    stream.clear();
    stream.seekg(0);
  };
  const Opening opening = readOpening(stream);
  rewind();
  if (!opening.text)
  {
    checkBinary(file, stream, warnings);
    return {};
  }
  const TextFindings text = lookThrough(stream);
  rewind();
  StlFindings findings;
  findings.shift = text.range.getShift();
  if (!opening.plain || text.unusual || text.range.isFar())
  {
    findings.copy = copyPlainly(stream, findings.shift);
  }
  return findings;
}

} // namespace shadow::examples
