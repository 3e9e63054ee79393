#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include <glm/glm.hpp>

#include "AdjacentTriangles.h"
#include "BufferTexels.h"
#include "Node.h"
#include "ReachableBitsBuffer.h"
#include "SEDGeometry.h"

class vtkOpenGLState;
class vtkShaderProgram;

namespace shadow
{

class TopologyAwareMesh;
struct FaceRun;

/// The GPU copy of a SEDGeometry.
///
/// For the volumes each vertex stands there twice: near and far copy. For the pre-pass see PrePassMesh.
class SEDGeometryDrawable
{
public:
  /// @param geometry  needed until update() or the last drawing
  explicit SEDGeometryDrawable(const SEDGeometry& geometry);
  SEDGeometryDrawable(const SEDGeometryDrawable&) = delete;
  SEDGeometryDrawable& operator=(const SEDGeometryDrawable&) = delete;

  /// Goes over to the mesh after it has moved: copies positions, and the triangles where the raster order of
  /// one has changed with them.
  ///
  /// @pre    isSameMeshMoved() of the geometry and the one so far
  /// @return bytes that were copied
  std::size_t update(const SEDGeometry& moved);

  /// Near and far copies for ShadowVolumeDrawable; made when first asked for.
  unsigned int getVolumeVertexBuffer();

  /// Triangles with adjacency for GeometryShaderSilhouette; made when first asked for.
  const AdjacentTriangles& getAdjacentTriangles();

  /// Draws all triangles in raster order with the current program. @pre the last vertex provokes
  /// @param reachableBits  for a program that reads them; may be nullptr
  void draw(vtkShaderProgram* program, const ReachableBitsBuffer* reachableBits);

  /// The same as VTK draws the surface: without the side it hides, gl_FrontFacing true for the side from
  /// which model space sees triangles counter-clockwise.
  /// @param mirrored  a face wound counter-clockwise in model space is clockwise on the screen
  void drawPrePass(vtkOpenGLState* state, vtkShaderProgram* program, const ReachableBitsBuffer* reachableBits,
                   FaceCulling culling, bool mirrored);

  /// Frees the GL objects. @pre their context is current, or is gone and @p contextLost
  void release(bool contextLost);

  /// Binds positions and corners as textures, and sets the program's samplers: see shaders/outlines/outlineFaces.glsl.
  /// @pre the program is current
  /// @return false when the GL cannot look up a mesh of this size
  bool bindFaceTexels(vtkOpenGLState* state, vtkShaderProgram* program);
  static void unbindFaceTexels(vtkOpenGLState* state);

  /// Draws vertices for faces of a topology-aware mesh, with nothing but their numbers and what
  /// bindFaceTexels() and the shared layout give: see shaders/outlines/outlineFace.vert. @pre a vertex array is bound
  /// @param mesh   made from the geometry, always the same for one; uploaded when first asked for
  /// @param runs   the faces to draw whole, each a triangle
  /// @param split  the faces to draw as three triangles, one for each edge
  /// @return false when the GL cannot look up a mesh of this size
  bool drawFaces(vtkOpenGLState* state, vtkShaderProgram* program, const TopologyAwareMesh& mesh,
                 const std::vector<FaceRun>& runs, const std::vector<FaceRun>& split);

  /// Texture units from this one on are not used by the faces.
  static constexpr int firstFreeUnit = 4;

  /// Vertices of the pre-pass, those of the triangles first.
  std::size_t getVertexCount() const { return this->vertices; }

  std::size_t getMemorySize() const;

private:
  std::size_t uploadPositions();
  std::size_t uploadVolumeVertices();
  std::size_t uploadSortedByWinding(std::vector<std::array<std::uint32_t, 3>> prePassTriangles);
  void bind(vtkShaderProgram* program, const ReachableBitsBuffer* reachableBits);
  void drawCulled(vtkOpenGLState* state, unsigned int hiddenSide);

  const SEDGeometry* geometry;
  std::uint64_t rasterOrder = 0; ///< of the triangles that were copied
  unsigned int vertexArray = 0;
  unsigned int vertexBuffer = 0;
  unsigned int indexBuffer = 0;
  unsigned int volumeVertexBuffer = 0;
  unsigned int sortedIndexBuffer = 0;  ///< triangles whose raster order is the input's come first
  std::size_t unreversedTriangles = 0; ///< these
  std::unique_ptr<AdjacentTriangles> adjacentTriangles;
  BufferTexels positionTexels{BufferTexels::Number::Float};
  BufferTexels cornerTexels{BufferTexels::Number::Unsigned};
  BufferTexels normalTexels{BufferTexels::Number::Unsigned};
  unsigned int normalBuffer = 0; ///< TAMLayout::Shared
  std::size_t normalBytes = 0;
  bool normalsUploaded = false; ///< they are those of the geometry
  std::size_t volumeBytes = 0;
  std::size_t triangles = 0;
  std::size_t vertices = 0;
};

} // namespace shadow
