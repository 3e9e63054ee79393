#include "LineDrawable.h"

#include <vtkOpenGLState.h>
#include <vtkShaderProgram.h>

#include "BufferUpload.h"
#include "OpenGL.h"
#include "SEDGeometryDrawable.h"

namespace shadow
{

namespace
{

constexpr int verticesOfLine = 6;

/// One number an edge: face * 8 + edge * 2, and 1 where the surface is on both of its sides.
std::vector<std::uint32_t> toCodes(const std::vector<FaceEdges>& lines)
{
  std::vector<std::uint32_t> codes;
  codes.reserve(lines.size() + lines.size() / 4);
  for (const FaceEdges& line : lines)
  {
    for (std::uint32_t edge = 0; edge < 3; ++edge)
    {
      const bool oneSided = (line.edges >> edge & 1u) != 0;
      if (oneSided || (line.edges >> (3 + edge) & 1u) != 0)
      {
        codes.push_back(8 * line.face + 2 * edge + (oneSided ? 0 : 1));
      }
    }
  }
  return codes;
}

} // namespace

bool LineDrawable::upload(const std::vector<FaceEdges>& lines)
{
  const std::vector<std::uint32_t> codes = toCodes(lines);
  this->edges = codes.size();
  this->bytes = 0;
  if (codes.empty())
  {
    return true;
  }
  if (this->buffer == 0)
  {
    glGenBuffers(1, &this->buffer);
  }
  this->bytes = uploadBuffer(GL_TEXTURE_BUFFER, this->buffer, codes, GL_STREAM_DRAW);
  glBindBuffer(GL_TEXTURE_BUFFER, 0);
  if (!this->texels.attach(this->buffer, codes.size()))
  {
    this->edges = 0;
    return false;
  }
  return true;
}

bool LineDrawable::draw(vtkOpenGLState* state, vtkShaderProgram* program, SEDGeometryDrawable& mesh) const
{
  if (this->edges == 0)
  {
    return true;
  }
  if (!mesh.bindFaceTexels(state, program))
  {
    return false;
  }
  this->texels.bind(state, static_cast<unsigned int>(program->GetHandle()),
                    SEDGeometryDrawable::firstFreeUnit, "lines");
  glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(verticesOfLine * this->edges));
  BufferTexels::unbind(state, SEDGeometryDrawable::firstFreeUnit);
  SEDGeometryDrawable::unbindFaceTexels(state);
  return true;
}

void LineDrawable::release(bool contextLost)
{
  this->texels.release(contextLost);
  if (!contextLost && this->buffer != 0)
  {
    glDeleteBuffers(1, &this->buffer);
  }
  this->buffer = 0;
  this->edges = this->bytes = 0;
}

} // namespace shadow
