#ifndef shadow_examples_GltfCopy_h
#define shadow_examples_GltfCopy_h

#include <string>
#include <vector>

namespace shadow::examples
{

/// A temporary copy of a glTF file, text or binary, as VTK's reader takes it: with an ending in lower case,
/// buffers beside it under plain names, and without textures, which the programs do not draw, so that none that
/// is missing or of an unknown kind refuses the mesh. Removed with this object.
class GltfCopy
{
public:
  /// @param[out] warnings  textures that are left out because they are not there
  /// @throws UserError that names the first cause: a buffer's file that is missing, an extension that the file
  /// requires and that is not read, or a file that is no glTF
  GltfCopy(const std::string& file, std::vector<std::string>& warnings);
  ~GltfCopy();
  GltfCopy(const GltfCopy&) = delete;
  GltfCopy& operator=(const GltfCopy&) = delete;

  const std::string& getName() const { return this->name; }

private:
  std::string folder;
  std::string name;
};

} // namespace shadow::examples

#endif
