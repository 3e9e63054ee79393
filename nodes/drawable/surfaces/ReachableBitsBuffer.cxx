#include "ReachableBitsBuffer.h"

#include <algorithm>

#include "OpenGL.h"

namespace shadow
{

void ReachableBitsBuffer::upload(const std::vector<glm::uvec2>& bits, std::size_t vertices)
{
  if (this->buffer == 0)
  {
    glGenBuffers(1, &this->buffer);
  }
  this->bytes = std::max(bits.size(), vertices) * sizeof(glm::uvec2);
  glBindBuffer(GL_ARRAY_BUFFER, this->buffer);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(this->bytes), nullptr, GL_STREAM_DRAW);
  glBufferSubData(GL_ARRAY_BUFFER, 0, static_cast<GLsizeiptr>(bits.size() * sizeof(glm::uvec2)), bits.data());
  glBindBuffer(GL_ARRAY_BUFFER, 0);
}

void ReachableBitsBuffer::release(bool contextLost)
{
  if (!contextLost)
  {
    glDeleteBuffers(1, &this->buffer);
  }
  this->buffer = 0;
  this->revision = 0;
}

} // namespace shadow
