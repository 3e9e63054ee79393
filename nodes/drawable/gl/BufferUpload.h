#pragma once

#include <cstddef>
#include <vector>

#include "OpenGL.h"

namespace shadow
{

/// Gives a buffer new contents.
///
/// @param usage  how often they change, such as GL_STATIC_DRAW
/// @post  the buffer is bound to @p target
/// @return bytes copied
template <class Element>
std::size_t uploadBuffer(GLenum target, unsigned int buffer, const std::vector<Element>& elements,
                         GLenum usage)
{
  const std::size_t size = elements.size() * sizeof(Element);
  glBindBuffer(target, buffer);
  glBufferData(target, static_cast<GLsizeiptr>(size), elements.data(), usage);
  return size;
}

} // namespace shadow
