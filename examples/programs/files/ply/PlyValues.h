#ifndef shadow_examples_PlyValues_h
#define shadow_examples_PlyValues_h

#include <cstddef>
#include <fstream>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "PlyHeader.h"

namespace shadow::examples
{

/// The numbers of a PLY file, one element after the other; nothing is read or made room for that the file does
/// not hold.
class PlyValues
{
public:
  virtual ~PlyValues() = default;

  /// Goes to the next element of a kind. @throws UserError when the file ends before it
  virtual void begin(const PlyElement& element) = 0;

  /// @throws UserError with the place when there is no such number
  virtual double next(const PlyType& type) = 0;

  /// Where the last number stood, for a message: "line 7" or "face 3".
  virtual std::string getPlace() const = 0;

  /// Bytes that are still to be read.
  std::size_t getRest() const { return this->rest; }

protected:
  std::size_t rest = 0;
};

/// @param stream  after the header
/// @param size    of the file from there on, in bytes
std::unique_ptr<PlyValues> openPlyValues(std::ifstream& stream, const PlyHeader& header, std::size_t size);

} // namespace shadow::examples

#endif
