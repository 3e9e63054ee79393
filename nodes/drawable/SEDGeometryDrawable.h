#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include "SEDGeometry.h"

class vtkOpenGLState;
class vtkShaderProgram;

namespace shadow
{

/// The GPU copy of a SEDGeometry: each vertex twice (near, far copy), and the triangles in raster order.
class SEDGeometryDrawable
{
public:
  explicit SEDGeometryDrawable(const SEDGeometry& geometry);
  SEDGeometryDrawable(const SEDGeometryDrawable&) = delete;
  SEDGeometryDrawable& operator=(const SEDGeometryDrawable&) = delete;

  unsigned int getVertexBuffer() const { return this->vertexBuffer; }

  /// Draws triangles [first, first + count) of the near copies with the current program.
  void draw(vtkShaderProgram* program, std::size_t first, std::size_t count);

  /// Frees the GL objects. @pre their context is current, or is gone and @p contextLost
  void release(bool contextLost);

  std::size_t getMemorySize() const { return this->bytes; }

  bool used = false; ///< since the cache was swept last

private:
  unsigned int vertexArray = 0;
  unsigned int vertexBuffer = 0;
  unsigned int indexBuffer = 0;
  std::size_t bytes = 0;
};

/// Two words for each triangle of a path, as a texture the pre-pass reads: which lights each side faces.
/// Split where one buffer texture cannot hold all triangles.
class ReachableBitsTexture
{
public:
  ReachableBitsTexture() = default;
  ReachableBitsTexture(const ReachableBitsTexture&) = delete;
  ReachableBitsTexture& operator=(const ReachableBitsTexture&) = delete;

  /// @param maximumTexels  see Capabilities
  void upload(const std::vector<glm::uvec2>& bits, std::size_t maximumTexels);

  struct Part
  {
    unsigned int buffer = 0;
    unsigned int texture = 0;
    std::size_t first = 0;
    std::size_t count = 0;
  };
  const std::vector<Part>& getParts() const { return this->parts; }

  void release(bool contextLost);
  std::size_t getMemorySize() const;

  std::uint64_t revision = 0; ///< what was uploaded last
  bool used = false;          ///< since the cache was swept last

private:
  std::vector<Part> parts;
};

} // namespace shadow
