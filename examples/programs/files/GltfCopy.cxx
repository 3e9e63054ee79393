#include "GltfCopy.h"

#include <array>
#include <cctype>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <nlohmann/json.hpp>

#include "UserError.h"

namespace shadow::examples
{

namespace
{

namespace fs = std::filesystem;
using nlohmann::json;

/// Header and chunks of the binary form are of 32-bit little-endian numbers.
constexpr std::uint32_t binaryMagic = 0x46546c67;
constexpr std::uint32_t jsonChunk = 0x4e4f534a;
constexpr std::size_t headerSize = 12;

std::uint32_t readNumber(const std::string& bytes, std::size_t place)
{
  std::uint32_t number = 0;
  for (std::size_t i = 4; i-- > 0;)
  {
    number = 256 * number + static_cast<unsigned char>(bytes.at(place + i));
  }
  return number;
}

void writeNumber(std::uint32_t number, std::string& bytes)
{
  for (int i = 0; i < 4; ++i)
  {
    bytes += static_cast<char>(number >> (8 * i) & 255u);
  }
}

/// "two%20words.bin" is the file "two words.bin".
std::string decodePercents(const std::string& uri)
{
  std::string name;
  for (std::size_t i = 0; i < uri.size(); ++i)
  {
    const bool coded = uri[i] == '%' && i + 2 < uri.size() && std::isxdigit(static_cast<unsigned char>(uri[i + 1])) &&
                       std::isxdigit(static_cast<unsigned char>(uri[i + 2]));
    name += coded ? static_cast<char>(std::stoi(uri.substr(i + 1, 2), nullptr, 16)) : uri[i];
    i += coded ? 2 : 0;
  }
  return name;
}

bool isData(const std::string& uri)
{
  return uri.rfind("data:", 0) == 0;
}

/// The file that a URI means, also where a name is not encoded though it has percent signs.
fs::path findFile(const fs::path& folder, const std::string& uri)
{
  std::error_code error;
  return fs::exists(folder / uri, error) ? folder / uri : folder / decodePercents(uri);
}

/// Extensions without which positions and indices cannot be read.
void checkExtensions(const json& document)
{
  static const std::array<const char*, 3> unread = {"KHR_draco_mesh_compression", "EXT_meshopt_compression",
                                                    "KHR_mesh_quantization"};
  for (const json& required : document.value("extensionsRequired", json::array()))
  {
    for (const char* extension : unread)
    {
      if (required == extension)
      {
        throw UserError(std::string("needs the extension ") + extension + ", which is not read");
      }
    }
  }
}

/// Every member whose name ends in "Texture", wherever it is.
void removeTextures(json& value)
{
  for (auto member = value.begin(); value.is_structured() && member != value.end();)
  {
    const std::string key = value.is_object() ? member.key() : "";
    const bool isTexture = key.size() >= 7 && key.find("exture", key.size() - 6) != std::string::npos;
    if (isTexture)
    {
      member = value.erase(member);
      continue;
    }
    if (member->is_structured())
    {
      removeTextures(*member);
    }
    ++member;
  }
}

void leaveOutTextures(const fs::path& folder, json& document, std::vector<std::string>& warnings)
{
  for (const json& image : document.value("images", json::array()))
  {
    const std::string uri = image.value("uri", "");
    std::error_code error;
    if (!uri.empty() && !isData(uri) && !fs::exists(findFile(folder, uri), error))
    {
      warnings.push_back("the texture " + decodePercents(uri) + " is not there");
    }
  }
  for (const char* list : {"images", "textures", "samplers"})
  {
    document.erase(list);
  }
  if (document.contains("materials"))
  {
    removeTextures(document["materials"]);
  }
}

/// Puts links to the buffers' files into the copy's folder.
void linkBuffers(const fs::path& from, const fs::path& to, json& document)
{
  std::size_t number = 0;
  for (json& buffer : document["buffers"])
  {
    const std::string uri = buffer.value("uri", "");
    if (uri.empty() || isData(uri))
    {
      continue;
    }
    const fs::path file = fs::absolute(findFile(from, uri));
    if (!fs::is_regular_file(file))
    {
      throw UserError("needs the file " + decodePercents(uri) + ", which is not there");
    }
    const std::string name = "buffer" + std::to_string(number++) + ".bin";
    fs::create_symlink(file, to / name);
    buffer["uri"] = name;
  }
}

struct Parts
{
  json document;
  std::string rest; ///< of the binary form: the chunks after the first
  bool binary = false;
};

Parts takeApart(const std::string& bytes)
{
  Parts parts;
  parts.binary = bytes.size() >= headerSize + 8 && readNumber(bytes, 0) == binaryMagic;
  std::size_t begin = 0;
  std::size_t size = bytes.size();
  if (parts.binary)
  {
    begin = headerSize + 8;
    size = readNumber(bytes, headerSize);
    if (readNumber(bytes, headerSize + 4) != jsonChunk || size > bytes.size() - begin)
    {
      throw UserError("cannot be read: the file is damaged");
    }
    parts.rest = bytes.substr(begin + size);
  }
  parts.document = json::parse(bytes.substr(begin, size), nullptr, false);
  if (!parts.document.is_object())
  {
    throw UserError("cannot be read: no glTF, its JSON is damaged");
  }
  return parts;
}

std::string putTogether(const Parts& parts)
{
  std::string text = parts.document.dump();
  if (!parts.binary)
  {
    return text;
  }
  text.append((4 - text.size() % 4) % 4, ' ');
  std::string bytes;
  writeNumber(binaryMagic, bytes);
  writeNumber(2, bytes);
  writeNumber(static_cast<std::uint32_t>(headerSize + 8 + text.size() + parts.rest.size()), bytes);
  writeNumber(static_cast<std::uint32_t>(text.size()), bytes);
  writeNumber(jsonChunk, bytes);
  return bytes + text + parts.rest;
}

} // namespace

GltfCopy::GltfCopy(const std::string& file, std::vector<std::string>& warnings)
{
  std::ifstream stream(file, std::ios::binary);
  Parts parts = takeApart({std::istreambuf_iterator<char>(stream), {}});
  const fs::path from = fs::absolute(file).parent_path();
  std::string pattern = (fs::temp_directory_path() / "model-XXXXXX").string();
  if (mkdtemp(pattern.data()) == nullptr)
  {
    throw UserError("needs a copy for its reader, which cannot be written to " + pattern);
  }
  this->folder = pattern;
  try
  {
    checkExtensions(parts.document);
    linkBuffers(from, this->folder, parts.document);
    leaveOutTextures(from, parts.document, warnings);
    this->name = this->folder + (parts.binary ? "/model.glb" : "/model.gltf");
    std::ofstream copy(this->name, std::ios::binary);
    copy << putTogether(parts);
    copy.close();
    if (!copy)
    {
      throw UserError("needs a copy for its reader, which cannot be written to " + this->name);
    }
  }
  catch (const json::exception&)
  {
    fs::remove_all(this->folder);
    throw UserError("cannot be read: the file is damaged");
  }
  catch (...)
  {
    fs::remove_all(this->folder);
    throw;
  }
}

GltfCopy::~GltfCopy()
{
  std::error_code error;
  std::filesystem::remove_all(this->folder, error);
}

} // namespace shadow::examples
