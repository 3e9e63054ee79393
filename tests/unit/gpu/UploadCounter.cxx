#include "UploadCounter.h"

#include "OpenGL.h"

namespace shadow::test
{

namespace
{

std::size_t bytes = 0;

// VTK's loader keeps each function of the GL in a variable.
decltype(glBufferData) bufferData = nullptr;
decltype(glBufferSubData) bufferSubData = nullptr;
decltype(glTexSubImage3D) texSubImage3D = nullptr;

void countBufferData(GLenum target, GLsizeiptr size, const void* data, GLenum usage)
{
  bytes += data != nullptr ? static_cast<std::size_t>(size) : 0;
  bufferData(target, size, data, usage);
}

void countBufferSubData(GLenum target, GLintptr offset, GLsizeiptr size, const void* data)
{
  bytes += static_cast<std::size_t>(size);
  bufferSubData(target, offset, size, data);
}

std::size_t channelsOf(GLenum format)
{
  switch (format)
  {
  case GL_RGBA:
  case GL_RGBA_INTEGER:
    return 4;
  case GL_RG:
  case GL_RG_INTEGER:
    return 2;
  default:
    return 1;
  }
}

void countTexSubImage3D(GLenum target, GLint level, GLint x, GLint y, GLint z, GLsizei width, GLsizei height,
                        GLsizei depth, GLenum format, GLenum type, const void* pixels)
{
  bytes += 4 * channelsOf(format) * static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
           static_cast<std::size_t>(depth);
  texSubImage3D(target, level, x, y, z, width, height, depth, format, type, pixels);
}

} // namespace

UploadCounter::UploadCounter()
{
  bytes = 0;
  bufferData = glBufferData;
  bufferSubData = glBufferSubData;
  texSubImage3D = glTexSubImage3D;
  glBufferData = countBufferData;
  glBufferSubData = countBufferSubData;
  glTexSubImage3D = countTexSubImage3D;
}

UploadCounter::~UploadCounter()
{
  glBufferData = bufferData;
  glBufferSubData = bufferSubData;
  glTexSubImage3D = texSubImage3D;
}

std::size_t UploadCounter::getBytes() const
{
  return bytes;
}

} // namespace shadow::test
