#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

class vtkRenderPass;
class vtkRenderWindow;
class vtkRenderer;

namespace shadow::test
{

/// Settings of the GL by name.
using GLStateValues = std::map<std::string, std::vector<int>>;

/// @pre  a context is current
GLStateValues readGLState();

/// Expects that a pass leaves the GL as it found it, in three renderings, below a camera and after the
/// lights.
/// @param where  for messages
void expectGLStateKept(vtkRenderer* renderer, vtkRenderPass* pass, const std::string& where);

/// Renders. @return fragments that pass all tests and are not discarded, of all that is drawn
std::size_t countFragments(vtkRenderWindow* window);

/// Names in use in the window's context, by kind.
std::map<std::string, int> countGLObjects(vtkRenderWindow* window);

} // namespace shadow::test
