#include "SEDGeometryDrawable.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <utility>

#include <vtkOpenGLState.h>
#include <vtkShaderProgram.h>

#include "BufferUpload.h"
#include "VertexLayout.h"

namespace shadow
{

namespace
{

struct PrePassMesh
{
  std::vector<glm::vec3>
      positions; ///< [t] is the last corner of triangle t; after these, corners that are last nowhere
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

PrePassMesh giveTrianglesTheirOwnVertex(const SEDGeometry& geometry)
{
  constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  const auto& triangles = geometry.getTriangles();
  std::vector<std::uint32_t> copyOf(geometry.getPositions().size(), none);
  PrePassMesh mesh;
  mesh.triangles = triangles;
  mesh.positions.reserve(triangles.size() + triangles.size() / 8);
  for (std::size_t triangle = 0; triangle < triangles.size(); ++triangle)
  {
    const std::uint32_t last = triangles[triangle][2];
    mesh.positions.push_back(geometry.getPositions()[last]);
    mesh.triangles[triangle][2] = static_cast<std::uint32_t>(triangle);
    copyOf[last] = copyOf[last] == none ? static_cast<std::uint32_t>(triangle) : copyOf[last];
  }
  for (auto& triangle : mesh.triangles)
  {
    for (const std::size_t corner : {0, 1})
    {
      std::uint32_t& copy = copyOf[triangle[corner]];
      if (copy == none)
      {
        copy = static_cast<std::uint32_t>(mesh.positions.size());
        mesh.positions.push_back(geometry.getPositions()[triangle[corner]]);
      }
      triangle[corner] = copy;
    }
  }
  return mesh;
}

} // namespace

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
  PrePassMesh mesh = giveTrianglesTheirOwnVertex(*this->geometry);
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
  const GLint bits = glGetAttribLocation(static_cast<GLuint>(program->GetHandle()), "reachableBits");
  if (bits >= 0 && reachableBits != nullptr)
  {
    glBindBuffer(GL_ARRAY_BUFFER, reachableBits->getBuffer());
    glEnableVertexAttribArray(static_cast<GLuint>(bits));
    // Vertices after the triangles' own provoke nothing: what they read does not matter.
    glVertexAttribIPointer(static_cast<GLuint>(bits), 2, GL_UNSIGNED_INT, sizeof(glm::uvec2), nullptr);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
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
    this->uploadSortedByWinding(giveTrianglesTheirOwnVertex(*this->geometry).triangles);
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
