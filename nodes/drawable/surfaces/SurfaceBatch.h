#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include <glm/glm.hpp>

#include "FloatTexels.h"
#include "SEDGeode.h"
#include "SEDGeometry.h"
#include "TriangleRuns.h"
#include "View.h"

class vtkOpenGLState;
class vtkShaderProgram;

namespace shadow
{

/// A small mesh under one path, to be drawn together with others.
struct BatchedSurface
{
  std::shared_ptr<const SEDGeometry> geometry;
  PathState* path = nullptr;
  glm::dmat4 wcFromMC{1.0}; ///< from positions relative to the geometry's origin
  bool mirrored = false;    ///< that turns counter-clockwise into clockwise

  bool isInView() const { return this->path->inView && this->path->reachableRevision != 0; }
};

/// The GPU copies of many small meshes in one set of buffers, so that one call draws all of them: for meshes of a
/// dozen triangles what a call costs is far more than what it draws.
///
/// Each vertex knows its mesh's place, by which the shader looks up matrices and lights, see
/// shaders/batchedObject.glsl. A mesh that is there under several paths is copied for each.
class SurfaceBatch
{
public:
  SurfaceBatch() = default;
  SurfaceBatch(const SurfaceBatch&) = delete;
  SurfaceBatch& operator=(const SurfaceBatch&) = delete;

  /// How many surfaces the GL can look up.
  static std::size_t findMostSurfaces();

  /// Goes over to these surfaces. What is on the GPU stays there where meshes have their place as before; one that
  /// has moved, with as many vertices and triangles, is copied alone.
  ///
  /// @pre    no more than findMostSurfaces(); the paths stay where they are until the last drawing
  void update(std::vector<BatchedSurface> newSurfaces, const View& view, const glm::dmat4& clipFromWC);

  bool isEmpty() const { return this->surfaces.empty(); }
  const std::vector<BatchedSurface>& getSurfaces() const { return this->surfaces; }

  /// Draws what is in view, all triangles in raster order.
  /// @pre    the program is current, of ShadowPrograms::PrePass with batchSwitch; the last vertex provokes
  /// @return triangles
  std::size_t drawPrePass(vtkOpenGLState* state, vtkShaderProgram* program, const View& view);

  /// Sets the sampler that all stages read. @pre the program is current
  void bindObjects(vtkOpenGLState* state, vtkShaderProgram* program) const;
  static void unbindObjects(vtkOpenGLState* state);

  /// A near or far copy, or a direction: see shaders/extrude.vert.
  struct Copy
  {
    glm::vec4 position;
    std::uint32_t object;
  };

  /// A buffer of near and far copies: 2 v and 2 v + 1 of vertex v, those of a surface from 2 * getFirstVertex() on;
  /// made when first asked for.
  unsigned int getCopies();

  /// Points vertexMC and object at a buffer of copies. @pre a vertex array is bound
  static void bindCopies(vtkShaderProgram* program, unsigned int copies);

  std::size_t getFirstVertex(std::size_t place) const { return this->blocks[place].firstVertex; }

  /// Another value whenever surfaces have other places in the buffers.
  std::uint64_t getLayout() const { return this->layout; }

  std::size_t getMemorySize() const;

  /// Frees the GL objects. @pre their context is current, or is gone and @p contextLost
  void release(bool contextLost);

  /// For ShadowPrograms::use().
  static constexpr const char* batchSwitch = "#define SHADOW_BATCHED\n";

  /// Texture units from this one on are not used by objects.
  static constexpr int firstFreeUnit = 1;

private:
  /// The part of the buffers that is one surface's.
  struct Block
  {
    std::shared_ptr<const SEDGeometry> geometry; ///< that was copied
    std::size_t firstVertex = 0;                 ///< of the geometry's vertices
    std::size_t firstCorner = 0;                 ///< of the pre-pass's vertices
    std::size_t firstTriangle = 0;
    std::uint64_t reachableRevision = 0; ///< of the bits that were copied
  };
  /// A vertex of the pre-pass.
  struct Corner
  {
    glm::vec3 position;
    std::uint32_t object;
  };

  bool keepsPlaces() const;
  void copyEverything();
  void copyMoved(); ///< @pre keepsPlaces()
  void copyReachableBits();
  void uploadObjects(const View& view, const glm::dmat4& clipFromWC);
  static std::vector<Corner> makeCorners(std::size_t place, const std::vector<glm::vec3>& positions);
  std::vector<Copy> makeCopies(std::size_t place) const;
  TriangleRuns findInView(bool mirrored) const;

  std::vector<BatchedSurface> surfaces;
  std::vector<Block> blocks; ///< of the surfaces
  std::uint64_t layout = 0;
  std::size_t triangles = 0;
  std::vector<glm::uvec2> reachableBits; ///< of all corners
  FloatTexels objects;
  unsigned int vertexArray = 0;
  unsigned int cornerBuffer = 0;
  unsigned int reachableBuffer = 0;
  unsigned int indexBuffer = 0;
  unsigned int copyBuffer = 0; ///< 0 until a volume is drawn
  std::size_t vertices = 0;    ///< of the geometries
};

} // namespace shadow
