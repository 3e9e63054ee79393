#include "TriangleDrawable.h"

#include <algorithm>
#include <string>

#include <vtkShaderProgram.h>

#include "OpenGL.h"

namespace shadow
{

namespace
{

/// Triangles copied at once: the staging memory stays small however large the scene is.
constexpr std::size_t blockSize = 16384;

} // namespace

std::size_t TriangleDrawable::upload(const VETCollection& collection)
{
  if (this->buffer == 0)
  {
    glGenVertexArrays(1, &this->vertexArray);
    glGenBuffers(1, &this->buffer);
  }
  glBindBuffer(GL_ARRAY_BUFFER, this->buffer);
  if (this->topologyRevision != collection.topologyRevision)
  {
    this->topologyRevision = collection.topologyRevision;
    this->positionRevision = 0;
    this->size = collection.triangles.size();
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(this->getMemorySize()), nullptr, GL_DYNAMIC_DRAW);
  }
  std::size_t copied = 0;
  std::uint64_t newest = this->positionRevision;
  for (const VETRange& range : collection.ranges)
  {
    if (range.positionRevision > this->positionRevision)
    {
      this->uploadRange(collection, range.firstTriangle, range.countTriangles());
      copied += range.countTriangles();
      newest = std::max(newest, range.positionRevision);
    }
  }
  this->positionRevision = newest;
  this->frame = collection.frame;
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  return copied;
}

void TriangleDrawable::uploadRange(const VETCollection& collection, std::size_t first, std::size_t count)
{
  static_assert(sizeof(Point) == 19 * sizeof(float), "the buffer has no gaps");
  for (const std::size_t end = first + count; first < end; first += this->staging.size())
  {
    this->staging.resize(std::min(blockSize, end - first));
    for (std::size_t place = 0; place < this->staging.size(); ++place)
    {
      Point& point = this->staging[place];
      for (std::size_t corner = 0; corner < 3; ++corner)
      {
        const std::uint32_t vertex = collection.triangles[first + place][corner];
        point.corners[corner] = {collection.high[vertex], collection.low[vertex]};
      }
      point.winding = collection.reversed.test(first + place) ? -1.0f : 1.0f;
    }
    glBufferSubData(GL_ARRAY_BUFFER, static_cast<GLintptr>(first * sizeof(Point)),
                    static_cast<GLsizeiptr>(this->staging.size() * sizeof(Point)), this->staging.data());
  }
}

void TriangleDrawable::bind(vtkShaderProgram* program) const
{
  // Programs are linked without fixed locations, so the attributes are bound for each draw.
  glBindBuffer(GL_ARRAY_BUFFER, this->buffer);
  const auto point = [program](const char* name, int tupleSize, std::size_t place)
  {
    program->EnableAttributeArray(name);
    program->UseAttributeArray(name, static_cast<int>(place * sizeof(float)), sizeof(Point), VTK_FLOAT,
                               tupleSize, vtkShaderProgram::NoNormalize);
  };
  const char* const names[] = {"cornerAHigh", "cornerALow",  "cornerBHigh",
                               "cornerBLow",  "cornerCHigh", "cornerCLow"};
  std::size_t place = 0;
  for (const char* name : names)
  {
    point(name, 3, place);
    place += 3;
  }
  point("winding", 1, place);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
}

void TriangleDrawable::draw(vtkShaderProgram* program, std::size_t first, std::size_t count)
{
  glBindVertexArray(this->vertexArray);
  this->bind(program);
  glDrawArrays(GL_POINTS, static_cast<GLint>(first), static_cast<GLsizei>(count));
  glBindVertexArray(0);
}

std::size_t TriangleDrawable::getMemorySize() const
{
  return this->size * sizeof(Point);
}

void TriangleDrawable::release(bool contextLost)
{
  if (!contextLost && this->buffer != 0)
  {
    glDeleteVertexArrays(1, &this->vertexArray);
    glDeleteBuffers(1, &this->buffer);
  }
  this->vertexArray = this->buffer = 0;
  this->size = 0;
  this->topologyRevision = this->positionRevision = 0;
}

} // namespace shadow
