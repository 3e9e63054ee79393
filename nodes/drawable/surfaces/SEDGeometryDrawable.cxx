#include "SEDGeometryDrawable.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include <vtkOpenGLState.h>
#include <vtkShaderProgram.h>

#include "BufferUpload.h"
#include "PrePassMesh.h"
#include "VertexLayout.h"

namespace shadow
{

SEDGeometryDrawable::SEDGeometryDrawable(const SEDGeometry& sedGeometry)
    : geometry(&sedGeometry), triangles(sedGeometry.getTriangles().size())
{
  glGenVertexArrays(1, &this->vertexArray);
  glGenBuffers(1, &this->vertexBuffer);
  glGenBuffers(1, &this->indexBuffer);
  this->uploadPositions();
}

std::size_t SEDGeometryDrawable::update(const SEDGeometry& moved)
{
  this->geometry = &moved;
  this->normalsUploaded = false;
  std::size_t copied = this->uploadPositions();
  if (this->volumeVertexBuffer != 0)
  {
    copied += this->uploadVolumeVertices();
  }
  return copied;
}

std::size_t SEDGeometryDrawable::uploadPositions()
{
  PrePassMesh mesh = makePrePassMesh(*this->geometry);
  this->vertices = mesh.positions.size();
  glBindVertexArray(this->vertexArray);
  std::size_t copied = uploadBuffer(GL_ARRAY_BUFFER, this->vertexBuffer, mesh.positions, GL_STATIC_DRAW);
  if (this->rasterOrder != this->geometry->getRasterOrder())
  {
    this->rasterOrder = this->geometry->getRasterOrder();
    copied += uploadBuffer(GL_ELEMENT_ARRAY_BUFFER, this->indexBuffer, mesh.triangles, GL_STATIC_DRAW);
    if (this->sortedIndexBuffer != 0)
    {
      copied += this->uploadSortedByWinding(std::move(mesh.triangles));
      glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, this->indexBuffer);
    }
  }
  glBindVertexArray(0);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  return copied;
}

std::size_t SEDGeometryDrawable::uploadVolumeVertices()
{
  std::vector<glm::vec4> copies;
  copies.reserve(2 * this->geometry->getPositions().size());
  for (const glm::vec3& position : this->geometry->getPositions())
  {
    copies.emplace_back(position, 1.0f);
    copies.emplace_back(position, 0.0f);
  }
  this->volumeBytes = uploadBuffer(GL_ARRAY_BUFFER, this->volumeVertexBuffer, copies, GL_STATIC_DRAW);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  return this->volumeBytes;
}

unsigned int SEDGeometryDrawable::getVolumeVertexBuffer()
{
  if (this->volumeVertexBuffer == 0)
  {
    glGenBuffers(1, &this->volumeVertexBuffer);
    this->uploadVolumeVertices();
  }
  return this->volumeVertexBuffer;
}

const AdjacentTriangles& SEDGeometryDrawable::getAdjacentTriangles()
{
  if (this->adjacentTriangles == nullptr)
  {
    this->adjacentTriangles = std::make_unique<AdjacentTriangles>(*this->geometry);
  }
  return *this->adjacentTriangles;
}

void SEDGeometryDrawable::bind(vtkShaderProgram* program, const ReachableBitsBuffer* reachableBits)
{
  glBindVertexArray(this->vertexArray);
  bindFloats(program, "vertexMC", this->vertexBuffer, 3);
  if (reachableBits != nullptr)
  {
    // Vertices after the triangles' own provoke nothing: what they read does not matter.
    bindAttribute(program, "reachableBits", reachableBits->getBuffer(),
                  {2, GL_UNSIGNED_INT, sizeof(glm::uvec2), 0});
  }
}

void SEDGeometryDrawable::draw(vtkShaderProgram* program, const ReachableBitsBuffer* reachableBits)
{
  this->bind(program, reachableBits);
  drawTriangles(0, this->triangles);
  glBindVertexArray(0);
}

// @post  the buffer is bound
std::size_t
SEDGeometryDrawable::uploadSortedByWinding(std::vector<std::array<std::uint32_t, 3>> prePassTriangles)
{
  const FacingBits& reversed = this->geometry->getInputReversed();
  const auto firstReversed = std::stable_partition(prePassTriangles.begin(), prePassTriangles.end(),
                                                   [&](const std::array<std::uint32_t, 3>& corners)
                                                   { return !reversed.test(corners[2]); });
  this->unreversedTriangles = static_cast<std::size_t>(firstReversed - prePassTriangles.begin());
  return uploadBuffer(GL_ELEMENT_ARRAY_BUFFER, this->sortedIndexBuffer, prePassTriangles, GL_STATIC_DRAW);
}

void SEDGeometryDrawable::drawPrePass(vtkOpenGLState* state, vtkShaderProgram* program,
                                      const ReachableBitsBuffer* reachableBits, FaceCulling culling,
                                      bool mirrored)
{
  this->bind(program, reachableBits);
  glFrontFace(mirrored ? GL_CW : GL_CCW);
  if (culling == FaceCulling::None)
  {
    drawTriangles(0, this->triangles);
  }
  else
  {
    // VTK calls back what is clockwise on the screen, mirrored or not.
    const bool front = (culling == FaceCulling::Front) != mirrored;
    this->drawCulled(state, front ? GL_FRONT : GL_BACK);
  }
  glFrontFace(GL_CCW);
  glBindVertexArray(0);
}

// @param hiddenSide  GL_FRONT or GL_BACK, by the input's winding
void SEDGeometryDrawable::drawCulled(vtkOpenGLState* state, unsigned int hiddenSide)
{
  if (this->sortedIndexBuffer == 0)
  {
    glGenBuffers(1, &this->sortedIndexBuffer);
    this->uploadSortedByWinding(makePrePassMesh(*this->geometry).triangles);
  }
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, this->sortedIndexBuffer);
  state->vtkglEnable(GL_CULL_FACE);
  state->vtkglCullFace(hiddenSide);
  drawTriangles(0, this->unreversedTriangles);
  state->vtkglCullFace(hiddenSide == GL_FRONT ? GL_BACK : GL_FRONT);
  drawTriangles(this->unreversedTriangles, this->triangles - this->unreversedTriangles);
  state->vtkglDisable(GL_CULL_FACE);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, this->indexBuffer);
}

void SEDGeometryDrawable::release(bool contextLost)
{
  this->positionTexels.release(contextLost);
  this->cornerTexels.release(contextLost);
  this->normalTexels.release(contextLost);
  if (!contextLost)
  {
    glDeleteVertexArrays(1, &this->vertexArray);
    glDeleteBuffers(1, &this->vertexBuffer);
    glDeleteBuffers(1, &this->indexBuffer);
    glDeleteBuffers(1, &this->volumeVertexBuffer);
    glDeleteBuffers(1, &this->sortedIndexBuffer);
    glDeleteBuffers(1, &this->normalBuffer);
  }
  if (this->adjacentTriangles != nullptr)
  {
    this->adjacentTriangles->release(contextLost);
  }
  this->vertexArray = this->vertexBuffer = this->indexBuffer = this->volumeVertexBuffer = 0;
  this->sortedIndexBuffer = this->normalBuffer = 0;
}

std::size_t SEDGeometryDrawable::getMemorySize() const
{
  constexpr std::size_t triangleSize = 3 * sizeof(std::uint32_t);
  return this->vertices * sizeof(glm::vec3) + this->triangles * triangleSize + this->volumeBytes +
         this->normalBytes + (this->sortedIndexBuffer != 0 ? this->triangles * triangleSize : 0) +
         (this->adjacentTriangles != nullptr ? this->adjacentTriangles->getMemorySize() : 0);
}

} // namespace shadow
