#include "FloatTexels.h"

#include "BufferUpload.h"

namespace shadow
{

void FloatTexels::upload(const std::vector<glm::vec4>& values)
{
  if (this->buffer == 0)
  {
    glGenBuffers(1, &this->buffer);
  }
  this->bytes = uploadBuffer(GL_TEXTURE_BUFFER, this->buffer, values, GL_STREAM_DRAW);
  glBindBuffer(GL_TEXTURE_BUFFER, 0);
  this->texels.attach(this->buffer, values.size());
}

void FloatTexels::bind(vtkOpenGLState* state, unsigned int program, int unit, const char* sampler) const
{
  this->texels.bind(state, program, unit, sampler);
}

void FloatTexels::release(bool contextLost)
{
  this->texels.release(contextLost);
  if (!contextLost)
  {
    glDeleteBuffers(1, &this->buffer);
  }
  this->buffer = 0;
  this->bytes = 0;
}

} // namespace shadow
