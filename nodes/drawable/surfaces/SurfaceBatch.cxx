#include "SurfaceBatch.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include <vtkOpenGLState.h>
#include <vtkShaderProgram.h>

#include "BufferUpload.h"
#include "PrePassMesh.h"
#include "Revision.h"
#include "VertexLayout.h"

namespace shadow
{

namespace
{

constexpr int objectUnit = 0;
constexpr std::size_t texelsOfObject = 5; // as batchedObject.glsl reads them; of a light fewer

using Triangle = std::array<std::uint32_t, 3>;

std::vector<Triangle> shift(std::vector<Triangle> triangles, std::size_t first)
{
  for (Triangle& triangle : triangles)
  {
    for (std::uint32_t& corner : triangle)
    {
      corner += static_cast<std::uint32_t>(first);
    }
  }
  return triangles;
}

template <class Element>
void replacePart(GLenum target, unsigned int buffer, std::size_t first, const std::vector<Element>& part)
{
  glBindBuffer(target, buffer);
  glBufferSubData(target, static_cast<GLintptr>(first * sizeof(Element)),
                  static_cast<GLsizeiptr>(part.size() * sizeof(Element)), part.data());
}

} // namespace

std::size_t SurfaceBatch::findMostSurfaces()
{
  return BufferTexels::findMost() / texelsOfObject;
}

void SurfaceBatch::update(std::vector<BatchedSurface> newSurfaces, const View& view, const glm::dmat4& clipFromWC)
{
  this->surfaces = std::move(newSurfaces);
  if (this->surfaces.empty())
  {
    this->release(false);
    return;
  }
  this->uploadObjects(view, clipFromWC);
  if (this->keepsPlaces())
  {
    this->copyMoved();
  }
  else
  {
    this->copyEverything();
  }
  this->copyReachableBits();
}

bool SurfaceBatch::keepsPlaces() const
{
  return this->vertexArray != 0 &&
         std::equal(this->surfaces.begin(), this->surfaces.end(), this->blocks.begin(), this->blocks.end(),
                    [](const BatchedSurface& surface, const Block& block)
                    {
                      // The same triangles, moved or not.
                      return surface.geometry->getRasterOrder() == block.geometry->getRasterOrder();
                    });
}

std::vector<SurfaceBatch::Corner> SurfaceBatch::makeCorners(std::size_t place,
                                                             const std::vector<glm::vec3>& positions)
{
  std::vector<Corner> corners;
  corners.reserve(positions.size());
  for (const glm::vec3& position : positions)
  {
    corners.push_back({position, static_cast<std::uint32_t>(place)});
  }
  return corners;
}

std::vector<SurfaceBatch::Copy> SurfaceBatch::makeCopies(std::size_t place) const
{
  std::vector<Copy> copies;
  const std::vector<glm::vec3>& positions = this->surfaces[place].geometry->getPositions();
  copies.reserve(2 * positions.size());
  for (const glm::vec3& position : positions)
  {
    copies.push_back({glm::vec4(position, 1.0f), static_cast<std::uint32_t>(place)});
    copies.push_back({glm::vec4(position, 0.0f), static_cast<std::uint32_t>(place)});
  }
  return copies;
}

void SurfaceBatch::copyEverything()
{
  if (this->vertexArray == 0)
  {
    glGenVertexArrays(1, &this->vertexArray);
    glGenBuffers(1, &this->cornerBuffer);
    glGenBuffers(1, &this->reachableBuffer);
    glGenBuffers(1, &this->indexBuffer);
  }
  this->layout = nextRevision();
  this->blocks.clear();
  this->vertices = this->triangles = 0;
  std::vector<Corner> corners;
  std::vector<Triangle> indices;
  for (std::size_t place = 0; place < this->surfaces.size(); ++place)
  {
    const SEDGeometry& geometry = *this->surfaces[place].geometry;
    const PrePassMesh mesh = makePrePassMesh(geometry);
    this->blocks.push_back({this->surfaces[place].geometry, this->vertices, corners.size(), indices.size()});
    const std::vector<Triangle> shifted = shift(mesh.triangles, corners.size());
    indices.insert(indices.end(), shifted.begin(), shifted.end());
    const std::vector<Corner> added = makeCorners(place, mesh.positions);
    corners.insert(corners.end(), added.begin(), added.end());
    this->vertices += geometry.getPositions().size();
  }
  this->triangles = indices.size();
  this->reachableBits.assign(corners.size(), glm::uvec2(0u));
  glBindVertexArray(this->vertexArray);
  uploadBuffer(GL_ARRAY_BUFFER, this->cornerBuffer, corners, GL_STATIC_DRAW);
  uploadBuffer(GL_ELEMENT_ARRAY_BUFFER, this->indexBuffer, indices, GL_STATIC_DRAW);
  glBindVertexArray(0);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  glDeleteBuffers(1, &this->copyBuffer);
  this->copyBuffer = 0;
}

void SurfaceBatch::copyMoved()
{
  for (std::size_t place = 0; place < this->surfaces.size(); ++place)
  {
    Block& block = this->blocks[place];
    if (block.geometry == this->surfaces[place].geometry)
    {
      continue;
    }
    block.geometry = this->surfaces[place].geometry;
    replacePart(GL_ARRAY_BUFFER, this->cornerBuffer, block.firstCorner,
                makeCorners(place, makePrePassMesh(*block.geometry).positions));
    if (this->copyBuffer != 0)
    {
      replacePart(GL_ARRAY_BUFFER, this->copyBuffer, 2 * block.firstVertex, this->makeCopies(place));
    }
    glBindBuffer(GL_ARRAY_BUFFER, 0);
  }
}

void SurfaceBatch::copyReachableBits()
{
  bool changed = false;
  for (std::size_t place = 0; place < this->surfaces.size(); ++place)
  {
    Block& block = this->blocks[place];
    const BatchedSurface& surface = this->surfaces[place];
    if (surface.isInView() && block.reachableRevision != surface.path->reachableRevision)
    {
      const std::vector<glm::uvec2>& bits = surface.path->reachableBits;
      std::copy(bits.begin(), bits.end(),
                this->reachableBits.begin() + static_cast<std::ptrdiff_t>(block.firstCorner));
      block.reachableRevision = surface.path->reachableRevision;
      changed = true;
    }
  }
  if (changed)
  {
    uploadBuffer(GL_ARRAY_BUFFER, this->reachableBuffer, this->reachableBits, GL_STREAM_DRAW);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
  }
}

void SurfaceBatch::uploadObjects(const View& view, const glm::dmat4& clipFromWC)
{
  std::vector<glm::vec4> values;
  values.reserve(texelsOfObject * this->surfaces.size());
  for (const BatchedSurface& surface : this->surfaces)
  {
    const glm::mat4 clipFromMC(clipFromWC * surface.wcFromMC);
    values.insert(values.end(), {clipFromMC[0], clipFromMC[1], clipFromMC[2], clipFromMC[3]});
    values.emplace_back(view.parallel ? view.viewDepth * surface.wcFromMC : glm::dvec4(0.0));
  }
  this->objects.upload(values);
}

std::size_t SurfaceBatch::drawPrePass(vtkOpenGLState* state, vtkShaderProgram* program, const View& view)
{
  glBindVertexArray(this->vertexArray);
  bindAttribute(program, "vertexMC", this->cornerBuffer, {3, GL_FLOAT, sizeof(Corner), 0});
  bindAttribute(program, "object", this->cornerBuffer,
                {1, GL_UNSIGNED_INT, sizeof(Corner), offsetof(Corner, object)});
  bindAttribute(program, "reachableBits", this->reachableBuffer, {2, GL_UNSIGNED_INT, sizeof(glm::uvec2), 0});
  this->bindObjects(state, program);
  std::size_t drawn = 0;
  for (const bool mirrored : {false, true})
  {
    const TriangleRuns runs = this->findInView(mirrored);
    glFrontFace(mirrored != view.mirrored ? GL_CW : GL_CCW);
    drawn += runs.draw();
  }
  glFrontFace(GL_CCW);
  unbindObjects(state);
  glBindVertexArray(0);
  return drawn;
}

TriangleRuns SurfaceBatch::findInView(bool mirrored) const
{
  TriangleRuns runs;
  for (std::size_t place = 0; place < this->surfaces.size(); ++place)
  {
    const BatchedSurface& surface = this->surfaces[place];
    if (surface.isInView() && surface.mirrored == mirrored)
    {
      runs.add(this->blocks[place].firstTriangle, surface.geometry->getTriangles().size());
    }
  }
  return runs;
}

void SurfaceBatch::bindObjects(vtkOpenGLState* state, vtkShaderProgram* program) const
{
  this->objects.bind(state, static_cast<unsigned int>(program->GetHandle()), objectUnit, "objectTexels");
}

void SurfaceBatch::unbindObjects(vtkOpenGLState* state)
{
  BufferTexels::unbind(state, objectUnit);
}

unsigned int SurfaceBatch::getCopies()
{
  if (this->copyBuffer == 0)
  {
    glGenBuffers(1, &this->copyBuffer);
    std::vector<Copy> copies;
    copies.reserve(2 * this->vertices);
    for (std::size_t place = 0; place < this->surfaces.size(); ++place)
    {
      const std::vector<Copy> added = this->makeCopies(place);
      copies.insert(copies.end(), added.begin(), added.end());
    }
    uploadBuffer(GL_ARRAY_BUFFER, this->copyBuffer, copies, GL_STATIC_DRAW);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
  }
  return this->copyBuffer;
}

void SurfaceBatch::bindCopies(vtkShaderProgram* program, unsigned int copies)
{
  bindAttribute(program, "vertexMC", copies, {4, GL_FLOAT, sizeof(Copy), 0});
  bindAttribute(program, "object", copies, {1, GL_UNSIGNED_INT, sizeof(Copy), offsetof(Copy, object)});
}

std::size_t SurfaceBatch::getMemorySize() const
{
  return this->reachableBits.size() * (sizeof(Corner) + 2 * sizeof(glm::uvec2)) +
         this->triangles * sizeof(Triangle) + (this->copyBuffer != 0 ? 2 * this->vertices * sizeof(Copy) : 0) +
         this->objects.getMemorySize();
}

void SurfaceBatch::release(bool contextLost)
{
  this->objects.release(contextLost);
  if (!contextLost)
  {
    glDeleteVertexArrays(1, &this->vertexArray);
    for (const unsigned int buffer :
         {this->cornerBuffer, this->reachableBuffer, this->indexBuffer, this->copyBuffer})
    {
      glDeleteBuffers(1, &buffer);
    }
  }
  this->vertexArray = this->cornerBuffer = this->reachableBuffer = this->indexBuffer = this->copyBuffer = 0;
  this->surfaces.clear();
  this->blocks.clear();
  this->reachableBits.clear();
  this->vertices = this->triangles = 0;
}

} // namespace shadow
