#pragma once

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

namespace shadow::truth
{

/// The OBJ files in a folder, sorted; none when there is no such folder.
inline std::vector<std::string> findMeshes(const std::string& folder)
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

/// A file's name as the name of a test can hold it.
inline std::string toTestName(const std::string& file)
{
  std::string name = std::filesystem::path(file).stem().string();
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return name;
}

} // namespace shadow::truth
