#include "MeshFiles.h"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <system_error>

namespace shadow::test
{

namespace
{

/// "7", "7/1/2" and "7//2" name vertex 6; "-1" names the last one so far.
std::uint32_t parseCorner(const std::string& word, std::size_t points)
{
  const long index = std::stol(word);
  return static_cast<std::uint32_t>(index > 0 ? index - 1 : static_cast<long>(points) + index);
}

} // namespace

std::vector<std::string> findMeshFiles(const std::string& folder)
{
  std::vector<std::string> files;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error))
  {
    if (entry.path().extension() == ".obj")
    {
      files.push_back(entry.path().string());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

TriangleSoup readMeshFile(const std::string& file)
{
  std::ifstream stream(file);
  TriangleSoup soup;
  for (std::string line; std::getline(stream, line);)
  {
    std::istringstream words(line);
    std::string kind;
    words >> kind;
    if (kind == "v")
    {
      glm::dvec3 point;
      words >> point.x >> point.y >> point.z;
      // As VTK reads them.
      soup.points.emplace_back(glm::vec3(point));
    }
    else if (kind == "f")
    {
      std::vector<std::uint32_t> corners;
      for (std::string word; words >> word;)
      {
        corners.push_back(parseCorner(word, soup.points.size()));
      }
      for (std::size_t corner = 2; corner < corners.size(); ++corner)
      {
        soup.triangles.push_back({corners[0], corners[corner - 1], corners[corner]});
      }
    }
  }
  if (soup.triangles.empty())
  {
    throw std::runtime_error(file + " holds no triangles");
  }
  return soup;
}

std::string toTestName(const std::string& file)
{
  std::string name = std::filesystem::path(file).stem().string();
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return name;
}

} // namespace shadow::test
