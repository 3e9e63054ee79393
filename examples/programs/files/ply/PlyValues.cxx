#include "PlyValues.h"

#include <algorithm>
#include <cstdint>
#include <cstring>

#include "TextLines.h"
#include "UserError.h"

namespace shadow::examples
{

namespace
{

// An element a line.
class TextValues : public PlyValues
{
public:
  TextValues(std::ifstream& theStream, std::size_t headerLines, std::size_t size)
      : stream(theStream), number(headerLines)
  {
    this->rest = size;
  }

  void begin(const PlyElement& element) override
  {
    if (element.properties.empty())
    {
      return;
    }
    do
    {
      if (!std::getline(this->stream, this->line))
      {
        throw UserError("line " + std::to_string(this->number) + ": the file ends before its last " + element.name);
      }
      ++this->number;
      this->rest -= std::min(this->rest, this->line.size() + 1);
      this->words = this->line;
    } while (this->line.find_first_not_of(" \t\r") == std::string::npos);
  }

  double next(const PlyType& /*type*/) override
  {
    const std::string_view word = nextWord(this->words);
    if (word.empty())
    {
      throw UserError(this->getPlace() + ": too few numbers");
    }
    double value = 0.0;
    if (examine(word, value) == Number::None)
    {
      throw UserError(this->getPlace() + ": not a number");
    }
    return value;
  }

  std::string getPlace() const override { return "line " + std::to_string(this->number); }

private:
  std::ifstream& stream;
  std::string line;
  std::string_view words;
  std::size_t number;
};

class BinaryValues : public PlyValues
{
public:
  BinaryValues(std::ifstream& theStream, bool isBig, std::size_t size) : stream(theStream), big(isBig)
  {
    this->rest = size;
  }

  void begin(const PlyElement& next) override
  {
    this->count = &next == this->element ? this->count + 1 : 1;
    this->element = &next;
  }

  double next(const PlyType& type) override
  {
    unsigned char bytes[8] = {};
    if (!this->stream.read(reinterpret_cast<char*>(bytes), static_cast<std::streamsize>(type.size)))
    {
      throw UserError(this->getPlace() + ": the file ends in it");
    }
    this->rest -= std::min(this->rest, type.size);
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < type.size; ++i)
    {
      const std::size_t place = this->big ? type.size - 1 - i : i;
      bits |= static_cast<std::uint64_t>(bytes[place]) << (8 * i);
    }
    if (type.real)
    {
      return type.size == 4 ? static_cast<double>(reinterpretBits<float>(static_cast<std::uint32_t>(bits)))
                            : reinterpretBits<double>(bits);
    }
    const bool negative = type.isSigned && (bits >> (8 * type.size - 1)) != 0;
    return static_cast<double>(bits) - (negative ? static_cast<double>(std::uint64_t{1} << (8 * type.size)) : 0.0);
  }

  std::string getPlace() const override { return this->element->name + " " + std::to_string(this->count); }

private:
  template <typename Real, typename Bits>
  static Real reinterpretBits(Bits bits)
  {
    static_assert(sizeof(Real) == sizeof(Bits));
    Real value;
    std::memcpy(&value, &bits, sizeof(Real));
    return value;
  }

  std::ifstream& stream;
  bool big;
  const PlyElement* element = nullptr;
  std::size_t count = 0;
};

} // namespace

std::unique_ptr<PlyValues> openPlyValues(std::ifstream& stream, const PlyHeader& header, std::size_t size)
{
  if (header.form == PlyHeader::Form::Text)
  {
    return std::make_unique<TextValues>(stream, header.lines, size);
  }
  return std::make_unique<BinaryValues>(stream, header.form == PlyHeader::Form::BigEndian, size);
}

} // namespace shadow::examples
