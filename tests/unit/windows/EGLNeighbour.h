#pragma once

#include <memory>
#include <string>
#include <vector>

namespace shadow::test
{

/// Somebody else in this process who draws through EGL, and ends the display that he opened when he is deleted.
class EGLNeighbour
{
public:
  virtual ~EGLNeighbour() = default;
  virtual bool draws() = 0;
};

/// How such a one can be had: each of EGL's platforms without a display that is there, and VTK's own window.
struct EGLNeighbourKind
{
  std::string name;
  /// @return nullptr where it does not draw, as a device that may not be used
  std::unique_ptr<EGLNeighbour> (*open)(int index);
  int index;
};

/// @pre there is EGL
std::vector<EGLNeighbourKind> listEGLNeighbours();

} // namespace shadow::test
