#pragma once

#include <cstddef>
#include <cstdint>

#include <vtkShaderProgram.h>

#include "OpenGL.h"

namespace shadow
{

/// Points an attribute of the program at a buffer of float tuples; a missing fourth value reads as 1.
/// @pre a vertex array is bound
inline void bindFloats(vtkShaderProgram* program, const char* attribute, unsigned int buffer, int tupleSize)
{
  // Programs are linked without fixed locations, so the attribute is bound for each draw.
  glBindBuffer(GL_ARRAY_BUFFER, buffer);
  program->EnableAttributeArray(attribute);
  program->UseAttributeArray(attribute, 0, static_cast<std::size_t>(tupleSize) * sizeof(float), VTK_FLOAT,
                             tupleSize, vtkShaderProgram::NoNormalize);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
}

/// Where an attribute's values lie in a buffer.
struct AttributeLayout
{
  int tupleSize;
  GLenum type; ///< GL_UNSIGNED_INT stays whole numbers
  std::size_t stride;
  std::size_t offset;
};

/// Points an attribute of the program at values in a buffer; one that the program lacks is left out.
/// @pre a vertex array is bound
inline void bindAttribute(vtkShaderProgram* program, const char* attribute, unsigned int buffer,
                          const AttributeLayout& layout)
{
  const GLint location = glGetAttribLocation(static_cast<GLuint>(program->GetHandle()), attribute);
  if (location < 0)
  {
    return;
  }
  const auto index = static_cast<GLuint>(location);
  const auto stride = static_cast<GLsizei>(layout.stride);
  const void* offset = reinterpret_cast<const void*>(layout.offset); // NOLINT: GL takes offsets as pointers
  glBindBuffer(GL_ARRAY_BUFFER, buffer);
  glEnableVertexAttribArray(index);
  if (layout.type == GL_UNSIGNED_INT)
  {
    glVertexAttribIPointer(index, layout.tupleSize, layout.type, stride, offset);
  }
  else
  {
    glVertexAttribPointer(index, layout.tupleSize, layout.type, GL_FALSE, stride, offset);
  }
  glBindBuffer(GL_ARRAY_BUFFER, 0);
}

/// Draws triangles of the bound index buffer. @pre a vertex array with 32-bit indices is bound
inline void drawTriangles(std::size_t first, std::size_t count)
{
  const std::size_t offset = first * 3 * sizeof(std::uint32_t);
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(3 * count), GL_UNSIGNED_INT,
                 reinterpret_cast<const void*>(offset)); // NOLINT: GL takes offsets as pointers
}

} // namespace shadow
