#include "PlyHeader.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <string_view>

#include "TextLines.h"
#include "UserError.h"

namespace shadow::examples
{

namespace
{

class HeaderLines
{
public:
  explicit HeaderLines(std::istream& theStream) : stream(theStream) {}

  PlyHeader read()
  {
    this->next();
    if (this->line != "ply")
    {
      this->refuse("a PLY file begins with \"ply\"");
    }
    bool formed = false;
    for (this->next(); this->line != "end_header"; this->next())
    {
      std::string_view rest = this->line;
      const std::string_view key = nextWord(rest);
      if (key == "format")
      {
        this->readForm(rest);
        formed = true;
      }
      else if (key == "element")
      {
        this->readElement(rest);
      }
      else if (key == "property")
      {
        this->readProperty(rest);
      }
      else if (!key.empty() && key != "comment" && key != "obj_info")
      {
        this->refuse("is no line of a PLY header");
      }
    }
    if (!formed)
    {
      this->refuse("the header ends without a format");
    }
    this->header.lines = this->number;
    return this->header;
  }

private:
  [[noreturn]] void refuse(const std::string& reason) const
  {
    throw UserError("line " + std::to_string(this->number) + ": " + reason);
  }

  void next()
  {
    ++this->number;
    if (!std::getline(this->stream, this->line))
    {
      this->refuse("the header has no end");
    }
    const std::size_t end = this->line.find_last_not_of(" \t\r");
    this->line.erase(end == std::string::npos ? 0 : end + 1);
  }

  void readForm(std::string_view rest)
  {
    static const std::map<std::string_view, PlyHeader::Form> forms = {
        {"ascii", PlyHeader::Form::Text},
        {"binary_little_endian", PlyHeader::Form::LittleEndian},
        {"binary_big_endian", PlyHeader::Form::BigEndian}};
    const auto found = forms.find(nextWord(rest));
    if (found == forms.end())
    {
      this->refuse("an unknown format");
    }
    this->header.form = found->second;
  }

  void readElement(std::string_view rest)
  {
    PlyElement element;
    element.name = nextWord(rest);
    element.line = this->number;
    const std::string_view count = nextWord(rest);
    const auto result = std::from_chars(count.data(), count.data() + count.size(), element.count);
    if (count.empty() || result.ec != std::errc() || result.ptr != count.data() + count.size())
    {
      this->refuse("an element needs a name and a count");
    }
    for (const PlyElement& other : this->header.elements)
    {
      if (other.name == element.name)
      {
        this->refuse("an element that is there already, since line " + std::to_string(other.line));
      }
    }
    this->header.elements.push_back(element);
  }

  PlyType readType(std::string_view word) const
  {
    static const std::map<std::string_view, PlyType> types = {
        {"char", {1, false, true}},    {"int8", {1, false, true}},    {"uchar", {1, false, false}},
        {"uint8", {1, false, false}},  {"short", {2, false, true}},   {"int16", {2, false, true}},
        {"ushort", {2, false, false}}, {"uint16", {2, false, false}}, {"int", {4, false, true}},
        {"int32", {4, false, true}},   {"uint", {4, false, false}},   {"uint32", {4, false, false}},
        {"float", {4, true, true}},    {"float32", {4, true, true}},  {"double", {8, true, true}},
        {"float64", {8, true, true}}};
    const auto found = types.find(word);
    if (found == types.end())
    {
      this->refuse("an unknown type of property");
    }
    return found->second;
  }

  void readProperty(std::string_view rest)
  {
    if (this->header.elements.empty())
    {
      this->refuse("a property before any element");
    }
    PlyElement& element = this->header.elements.back();
    PlyProperty property;
    std::string_view type = nextWord(rest);
    if (type == "list")
    {
      property.count = this->readType(nextWord(rest));
      type = nextWord(rest);
      if (property.count.real)
      {
        this->refuse("the length of a list is no whole number");
      }
    }
    property.type = this->readType(type);
    property.name = nextWord(rest);
    if (property.name.empty())
    {
      this->refuse("a property without a name");
    }
    if (element.find(property.name) < element.properties.size())
    {
      this->refuse("a property that is there already");
    }
    this->checkKind(element.name, property);
    element.properties.push_back(property);
  }

  // VTK's reader writes a list over what it has room for as a number, and frees a number as if it were a list.
  void checkKind(const std::string& element, const PlyProperty& property) const
  {
    static const std::vector<std::string> numbers = {"x",   "y",     "z",    "nx",    "ny",
                                                     "nz",  "red",   "green", "blue", "alpha",
                                                     "diffuse_red", "diffuse_green", "diffuse_blue"};
    const bool indices = property.name == "vertex_indices" || property.name == "vertex_index";
    if ((element == "face" || element == "tristrips") && indices && (!property.isList() || property.type.real))
    {
      this->refuse(property.name + " is no list of whole numbers");
    }
    const bool isNumber = std::find(numbers.begin(), numbers.end(), property.name) != numbers.end();
    if ((element == "vertex" || element == "face") && isNumber && property.isList())
    {
      this->refuse(property.name + " is a list");
    }
  }

  std::istream& stream;
  std::string line;
  std::size_t number = 0;
  PlyHeader header;
};

} // namespace

std::size_t PlyElement::find(const std::string& property) const
{
  const auto found = std::find_if(this->properties.begin(), this->properties.end(),
                                  [&property](const PlyProperty& each) { return each.name == property; });
  return static_cast<std::size_t>(found - this->properties.begin());
}

PlyHeader readPlyHeader(std::istream& stream)
{
  return HeaderLines(stream).read();
}

} // namespace shadow::examples
