#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "OpenGL.h"

namespace shadow
{

/// Runs of triangles of an index buffer, drawn by one call.
class TriangleRuns
{
public:
  void add(std::size_t first, std::size_t count)
  {
    this->triangles += count;
    if (!this->counts.empty() && this->end == first)
    {
      this->counts.back() += static_cast<GLsizei>(3 * count);
    }
    else
    {
      this->counts.push_back(static_cast<GLsizei>(3 * count));
      // GL takes offsets as pointers.
      this->offsets.push_back(reinterpret_cast<const void*>(3 * first * sizeof(std::uint32_t))); // NOLINT
    }
    this->end = first + count;
  }

  /// @pre a vertex array with 32-bit indices is bound
  /// @return triangles
  std::size_t draw() const
  {
    if (!this->counts.empty())
    {
      glMultiDrawElements(GL_TRIANGLES, this->counts.data(), GL_UNSIGNED_INT, this->offsets.data(),
                          static_cast<GLsizei>(this->counts.size()));
    }
    return this->triangles;
  }

private:
  std::vector<GLsizei> counts;
  std::vector<const void*> offsets;
  std::size_t end = 0; ///< of the last run
  std::size_t triangles = 0;
};

} // namespace shadow
