#ifndef shadow_examples_PlyHeader_h
#define shadow_examples_PlyHeader_h

#include <cstddef>
#include <cstdint>
#include <istream>
#include <string>
#include <vector>

namespace shadow::examples
{

struct PlyType
{
  std::size_t size = 0; ///< in bytes
  bool real = false;
  bool isSigned = false;
};

struct PlyProperty
{
  std::string name;
  PlyType type;  ///< of a list: of its values
  PlyType count; ///< size 0: no list
  bool isList() const { return this->count.size > 0; }
};

struct PlyElement
{
  std::string name;
  std::uintmax_t count = 0;
  std::size_t line = 0; ///< of the header
  std::vector<PlyProperty> properties;

  /// @return where the property stands; properties.size() when there is none
  std::size_t find(const std::string& property) const;
};

/// What stands before the numbers of a PLY file.
struct PlyHeader
{
  enum class Form
  {
    Text,
    LittleEndian,
    BigEndian
  };

  Form form = Form::Text;
  std::vector<PlyElement> elements;
  std::size_t lines = 0; ///< of the header, the last is "end_header"
};

/// Reads the header, and no more.
///
/// @throws UserError with the number of the first line that is wrong: an unknown word, type or form, a count that
/// is none, an element or a property that is there twice, or has a type that it cannot have
PlyHeader readPlyHeader(std::istream& stream);

} // namespace shadow::examples

#endif
