#ifndef shadow_examples_TextLines_h
#define shadow_examples_TextLines_h

#include <cstddef>
#include <istream>
#include <string>
#include <string_view>

namespace shadow::examples
{

/// Takes the next word off the front of a line; empty at the end.
std::string_view nextWord(std::string_view& line);

enum class Number
{
  Finite,
  NotFinite,
  None
};

/// Reads a word as a number, the same in every locale.
///
/// @param[out] value  the number; infinite where it is too large
Number examine(std::string_view word, double& value);

/// Reads the lines of an OBJ file as they are meant: without a byte order mark, without comments, and together
/// with those that they go on in after a backslash. A comment goes on in no other line.
class ObjLines
{
public:
  explicit ObjLines(std::istream& theStream) : stream(theStream) {}

  /// @return false at the end of the file
  bool next(std::string& line);

  std::size_t getNumber() const { return this->number; } ///< of the last line that was read, from 1

  /// A line so far was written in a way that is right, but that VTK's reader does not know.
  bool hasUnusual() const { return this->unusual; }

private:
  bool isGoingOn(std::string& part);

  std::istream& stream;
  std::size_t number = 0;
  bool unusual = false;
};

} // namespace shadow::examples

#endif
