#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "SceneFrame.h"
#include "VETCollection.h"

class vtkShaderProgram;

namespace shadow
{

/// Hands every triangle of a VETCollection to a vertex shader as one point that carries the triangle's three
/// corners; gl_VertexID is the triangle.
///
/// @par Memory  76 bytes a triangle
/// @par Source  Shi 2006, chapters 3.3 and 4.3.2
class TriangleDrawable
{
public:
  TriangleDrawable() = default;
  TriangleDrawable(const TriangleDrawable&) = delete;
  TriangleDrawable& operator=(const TriangleDrawable&) = delete;

  /// Copies what of the collection changed since the last call.
  /// @return  triangles that were copied
  std::size_t upload(const VETCollection& collection);

  /// Draws points @p first to @p first + @p count - 1. Attributes: cornerAHigh to cornerCLow (vec3) and
  /// winding (float), see shaders/facing.vert.
  /// @pre  @p program is current
  void draw(vtkShaderProgram* program, std::size_t first, std::size_t count);

  const SceneFrame& getFrame() const { return this->frame; } ///< of the positions that were copied
  std::size_t getSize() const { return this->size; }         ///< triangles
  std::size_t getMemorySize() const;

  /// Frees the GL objects. @pre their context is current, or is gone and @p contextLost
  void release(bool contextLost = false);

private:
  /// As the buffer holds it.
  struct Point
  {
    SplitVector corners[3];
    float winding;
  };
  void uploadRange(const VETCollection& collection, std::size_t first, std::size_t count);
  void bind(vtkShaderProgram* program) const;

  SceneFrame frame;
  unsigned int vertexArray = 0;
  unsigned int buffer = 0;
  std::size_t size = 0;
  std::uint64_t topologyRevision = 0;
  std::uint64_t positionRevision = 0; ///< the largest that was copied
  std::vector<Point> staging;
};

} // namespace shadow
