#pragma once

#include <cstddef>
#include <vector>

#include <glm/glm.hpp>

#include "BufferTexels.h"

class vtkOpenGLState;

namespace shadow
{

/// Float tuples of a buffer of their own, to be looked up by index, that change often.
class FloatTexels
{
public:
  FloatTexels() = default;
  FloatTexels(const FloatTexels&) = delete;
  FloatTexels& operator=(const FloatTexels&) = delete;

  /// Replaces all. @pre no more than BufferTexels::findMost()
  void upload(const std::vector<glm::vec4>& values);

  /// See BufferTexels::bind(). @pre upload() has succeeded
  void bind(vtkOpenGLState* state, unsigned int program, int unit, const char* sampler) const;

  std::size_t getMemorySize() const { return this->bytes; }

  /// Frees the GL objects. @pre their context is current, or is gone and @p contextLost
  void release(bool contextLost = false);

private:
  unsigned int buffer = 0;
  std::size_t bytes = 0;
  BufferTexels texels{BufferTexels::Number::Float4};
};

} // namespace shadow
