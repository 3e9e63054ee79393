#include "TexelReadBack.h"

#include <cstring>

#include <vtkOpenGLState.h>

#include "OpenGL.h"
#include "PixelTransferScope.h"
#include "Stopwatch.h"
#include "TexelArray.h"

namespace shadow
{

void TexelReadBack::start(vtkOpenGLState* state, const TexelArray& texels)
{
  const Stopwatch watch;
  this->dropFence();
  if (this->buffer == 0)
  {
    glGenBuffers(1, &this->buffer);
    glGenFramebuffers(1, &this->framebuffer);
  }
  const PixelTransferScope transfer;
  const std::size_t texelBytes = 4u * static_cast<std::size_t>(texels.getChannels());
  glBindBuffer(GL_PIXEL_PACK_BUFFER, this->buffer);
  this->bytes = texelBytes * texels.getSize();
  if (this->capacity < this->bytes || this->bytes < this->capacity / 4)
  {
    this->capacity = this->bytes;
    glBufferData(GL_PIXEL_PACK_BUFFER, static_cast<GLsizeiptr>(this->capacity), nullptr, GL_STREAM_READ);
  }
  state->PushFramebufferBindings();
  state->vtkglBindFramebuffer(GL_READ_FRAMEBUFFER, this->framebuffer);
  for (int layer = 0; layer < texels.getLayers(); ++layer)
  {
    texels.attachLayer(GL_READ_FRAMEBUFFER, layer);
    glReadBuffer(GL_COLOR_ATTACHMENT0);
    // Whole rows, then what there is of the last: texels beyond would not fit the buffer.
    const auto width = static_cast<std::size_t>(texels.getWidth());
    const std::size_t rows = texels.getCountOfLayer(layer) / width;
    const std::size_t rest = texels.getCountOfLayer(layer) % width;
    const std::size_t offset = texelBytes * texels.getFirstOfLayer(layer);
    const auto read = [&](std::size_t row, std::size_t columns, std::size_t count)
    {
      if (columns * count > 0)
      {
        const std::size_t place = offset + texelBytes * row * width;
        glReadPixels(0, static_cast<GLint>(row), static_cast<GLsizei>(columns), static_cast<GLsizei>(count),
                     texels.getPixelFormat(), texels.getPixelType(),
                     reinterpret_cast<void*>(place)); // NOLINT: GL takes offsets as pointers
      }
    };
    read(0, width, rows);
    read(rows, rest, 1);
  }
  // The texture may be freed before this is.
  glFramebufferTextureLayer(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, 0, 0, 0);
  state->PopFramebufferBindings();
  this->fence = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
  glFlush();
  this->times = {};
  this->times.start = watch.getMilliseconds();
}

bool TexelReadBack::isReady() const
{
  GLint status = GL_UNSIGNALED;
  glGetSynciv(static_cast<GLsync>(this->fence), GL_SYNC_STATUS, 1, nullptr, &status);
  return status == GL_SIGNALED;
}

bool TexelReadBack::fetch(std::vector<std::uint32_t>& words)
{
  words.clear();
  if (this->fence == nullptr)
  {
    return false;
  }
  const Stopwatch waiting;
  constexpr GLuint64 second = 1000000000u;
  GLenum result = GL_TIMEOUT_EXPIRED;
  while (result == GL_TIMEOUT_EXPIRED)
  {
    result = glClientWaitSync(static_cast<GLsync>(this->fence), GL_SYNC_FLUSH_COMMANDS_BIT, second);
  }
  this->times.wait = waiting.getMilliseconds();
  this->dropFence();
  const Stopwatch copying;
  const PixelTransferScope transfer;
  glBindBuffer(GL_PIXEL_PACK_BUFFER, this->buffer);
  bool kept = result != GL_WAIT_FAILED;
  if (kept && this->bytes > 0)
  {
    const void* source =
        glMapBufferRange(GL_PIXEL_PACK_BUFFER, 0, static_cast<GLsizeiptr>(this->bytes), GL_MAP_READ_BIT);
    kept = source != nullptr;
    if (kept)
    {
      words.resize(this->bytes / sizeof(std::uint32_t));
      std::memcpy(words.data(), source, this->bytes);
      kept = glUnmapBuffer(GL_PIXEL_PACK_BUFFER) == GL_TRUE;
    }
  }
  this->times.copy = copying.getMilliseconds();
  return kept;
}

void TexelReadBack::dropFence()
{
  if (this->fence != nullptr)
  {
    glDeleteSync(static_cast<GLsync>(this->fence));
    this->fence = nullptr;
  }
}

void TexelReadBack::release(bool contextLost)
{
  if (contextLost)
  {
    this->fence = nullptr;
  }
  this->dropFence();
  if (!contextLost && this->buffer != 0)
  {
    glDeleteBuffers(1, &this->buffer);
    glDeleteFramebuffers(1, &this->framebuffer);
  }
  this->buffer = this->framebuffer = 0;
  this->capacity = this->bytes = 0;
}

} // namespace shadow
