#pragma once

#include <stdexcept>
#include <string>

#include "Capabilities.h"
#include "OpenGL.h"
#include "ShadowScene.h"

namespace shadow::benchmarks
{

/// Which GL draws, and through what: a line, and one more where its numbers are not a GPU's.
/// @throws std::runtime_error when none does
inline std::string describeGL()
{
  truth::ShadowScene scene(16, 16);
  scene.window->Render();
  if (!scene.window->IsUsable())
  {
    throw std::runtime_error("there is no OpenGL context to draw into");
  }
  const auto text = [](GLenum name) { return std::string(reinterpret_cast<const char*>(glGetString(name))); };
  const std::string line =
      "GL: " + text(GL_RENDERER) + ", " + text(GL_VERSION) + ", through " + scene.window->GetBackend() + "\n";
  return line + (queryCapabilities().software ? "This GL is software: all numbers, those of GPU methods too, are a CPU's "
                                                "and tell nothing about a GPU.\n"
                                              : "");
}

} // namespace shadow::benchmarks
