#include "StlFile.h"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string_view>

#include "TextLines.h"
#include "UserError.h"

namespace shadow::examples
{

namespace
{

constexpr std::string_view byteOrderMark = "\xef\xbb\xbf";

/// vtkSTLReader has lines of 256 characters.
constexpr std::size_t longestLine = 250;

std::string lowerCase(std::string_view word)
{
  std::string result(word);
  std::transform(result.begin(), result.end(), result.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return result;
}

std::string firstWord(const std::string& line)
{
  std::string_view rest = line;
  return lowerCase(nextWord(rest));
}

bool isComment(const std::string& word)
{
  return word.empty() || word[0] == '#' || word[0] == ';' || word.rfind("//", 0) == 0;
}

/// What stands before the line that begins with "solid": a mark, comments, empty lines.
struct Opening
{
  bool text = false;
  bool plain = true; ///< nothing
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
    const std::string word = firstWord(line);
    if (word == "solid")
    {
      opening.text = true;
      return opening;
    }
    if (!isComment(word))
    {
      return {};
    }
    opening.plain = false;
  }
  return {};
}

bool hasLongLine(std::istream& stream)
{
  for (std::string line; std::getline(stream, line);)
  {
    if (line.size() > longestLine)
    {
      return true;
    }
  }
  return false;
}

std::unique_ptr<TemporaryModel> copyPlainly(std::istream& stream)
{
  auto copy = std::make_unique<TemporaryModel>(".stl");
  bool begun = false;
  for (std::string line; std::getline(stream, line);)
  {
    if (line.rfind(byteOrderMark, 0) == 0)
    {
      line.erase(0, byteOrderMark.size());
    }
    const std::string word = firstWord(line);
    const bool named = word == "solid" || word == "endsolid";
    begun = begun || named;
    if (begun && !isComment(word))
    {
      copy->getStream() << (named ? word + " model" : line) << '\n';
    }
  }
  copy->finish();
  return copy;
}

// vtkSTLReader reads to the end of the file whatever the header says, so a file that was cut off or is no STL
// at all would become a mesh of random triangles.
void checkBinary(const std::string& file, std::istream& stream)
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
}

} // namespace

std::unique_ptr<TemporaryModel> checkStl(const std::string& file)
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
    checkBinary(file, stream);
    return nullptr;
  }
  const bool isLong = hasLongLine(stream);
  rewind();
  return opening.plain && !isLong ? nullptr : copyPlainly(stream);
}

} // namespace shadow::examples
