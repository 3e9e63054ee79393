#pragma once

#include <cstddef>
#include <vector>

#include <glm/glm.hpp>

#include "BufferTexels.h"
#include "TopologyAwareMesh.h"

class vtkOpenGLState;
class vtkShaderProgram;

namespace shadow
{

class SEDGeometryDrawable;

/// The lines of a mesh for one eye, drawn from the faces of its topology-aware mesh: positions and corners
/// are looked up in the buffers of the SEDGeometryDrawable, where they are once for all.
///
/// Beyond the paper, whose vertex stage could not look anything up: each edge is drawn by one face, as the
/// rectangle that covers its line.
///
/// @par Memory  4 bytes a line
/// @par Source  Valient, "Hardware Generated Object Silhouettes", section 3.1
class LineDrawable
{
public:
  LineDrawable() = default;
  LineDrawable(const LineDrawable&) = delete;
  LineDrawable& operator=(const LineDrawable&) = delete;

  /// Replaces the lines.
  /// @return false when they are more than the GL can look up; there are then none
  bool upload(const std::vector<FaceEdges>& lines);

  /// Draws them with the current program, see shaders/outlines/outlineEdge.vert. @pre a vertex array is bound
  /// @return false when the GL cannot look up a mesh of this size
  bool draw(vtkOpenGLState* state, vtkShaderProgram* program, SEDGeometryDrawable& mesh) const;

  std::size_t countLines() const { return this->edges; }

  /// Frees the GL objects. @pre their context is current, or is gone and @p contextLost
  void release(bool contextLost = false);
  std::size_t getMemorySize() const { return this->bytes; }

private:
  unsigned int buffer = 0;
  BufferTexels texels{BufferTexels::Number::Unsigned};
  std::size_t edges = 0;
  std::size_t bytes = 0;
};

} // namespace shadow
