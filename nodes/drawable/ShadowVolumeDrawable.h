#pragma once

#include <cstddef>
#include <cstdint>

#include "SEDGeode.h"
#include "ShadowVolume.h"

class vtkOpenGLState;
class vtkShaderProgram;

namespace shadow
{

/// The GPU copy of a ShadowVolume: indices into the vertices of a SEDGeometryDrawable. Draws it into the
/// stencil.
class ShadowVolumeDrawable
{
public:
  ShadowVolumeDrawable() = default;
  ShadowVolumeDrawable(const ShadowVolumeDrawable&) = delete;
  ShadowVolumeDrawable& operator=(const ShadowVolumeDrawable&) = delete;

  void upload(const ShadowVolume& volume);

  /// Counts the volume: +1 for each of its faces that is entered, -1 for each that is left, in front of the
  /// surface (z-pass) or the other way round behind it (z-fail).
  ///
  /// Sides are drawn a few units of rounding farther: where one starts at the edge of a lit surface it would
  /// else be a matter of rounding whether it is in front of that surface.
  ///
  /// @param reversedDepth  see DepthRange
  /// @param mirrored  a face wound counter-clockwise in model space is clockwise on the screen
  /// @pre   the program's uniforms are set, the depth test is on, nothing but the stencil is written
  void draw(vtkOpenGLState* state, vtkShaderProgram* program, unsigned int vertexBuffer, StencilCount count,
            bool reversedDepth, bool mirrored);

  void release(bool contextLost);
  std::size_t getMemorySize() const { return this->bytes; }

  std::uint64_t revision = 0; ///< what was uploaded last
  bool used = false;          ///< since the cache was swept last

private:
  unsigned int vertexArray = 0;
  unsigned int indexBuffer = 0;
  std::size_t sideTriangles = 0;    ///< the first in the buffer
  std::size_t outwardTriangles = 0; ///< then caps that are wound counter-clockwise seen from outside
  std::size_t inwardTriangles = 0;  ///< the rest: ShadowVolume::lightCapReversed
  std::size_t bytes = 0;
};

} // namespace shadow
