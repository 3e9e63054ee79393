#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "SEDGeometry.h"
#include "SceneFrame.h"
#include "TexelArray.h"

class vtkOpenGLState;

namespace shadow
{

/// The tables of a SEDGeometry as a shader looks them up by index: see shaders/geometryTexels.glsl.
///
/// @par Memory  16 bytes a vertex, a triangle and an edge
/// @par Source  Brabec & Seidel 2003 (vertices in a float texture)
class GeometryTexels
{
public:
  GeometryTexels() = default;
  GeometryTexels(const GeometryTexels&) = delete;
  GeometryTexels& operator=(const GeometryTexels&) = delete;

  /// Copies the geometry. @return false with a line in @p error when the GL has no room for it
  bool upload(const SEDGeometry& geometry, std::string& error);

  /// Copies what of a mesh that moved is not the same: positions, and triangles where the raster order of
  /// one has changed with them.
  ///
  /// @pre    isSameMeshMoved() of the geometry and the one that was copied last
  /// @return texels that were copied
  std::size_t update(const SEDGeometry& geometry);

  /// Binds the tables to texture units @p firstUnit to @p firstUnit + 2 and sets the program's uniforms.
  /// @param program  name of a GL program that is current
  void bind(vtkOpenGLState* state, unsigned int program, int firstUnit) const;

  /// Model space relative to the origin, scaled to the geometry's size: what facing is evaluated in.
  const SceneFrame& getFrame() const { return this->frame; }

  void release(bool contextLost = false);
  std::size_t getMemorySize() const;

private:
  bool uploadTriangles(const SEDGeometry& geometry, std::string& error);
  void uploadPositions(const SEDGeometry& geometry);

  TexelArray positions{TexelFormat::Float4}; ///< xyz
  TexelArray triangles{TexelFormat::UInt4};  ///< vertices in raster order; w = 1: oriented against it
  TexelArray edges{TexelFormat::UInt4};      ///< vertices, triangles: see Edge
  SceneFrame frame;
  std::uint64_t rasterOrder = 0; ///< SEDGeometry::getRasterOrder() of the triangles that were copied
};

} // namespace shadow
