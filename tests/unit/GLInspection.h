#pragma once

#include <map>
#include <string>
#include <vector>

class vtkRenderWindow;

namespace shadow::test
{

/// Settings of the GL by name.
using GLStateValues = std::map<std::string, std::vector<int>>;

/// @pre  a context is current
GLStateValues readGLState();

/// Names in use in the window's context, by kind.
std::map<std::string, int> countGLObjects(vtkRenderWindow* window);

} // namespace shadow::test
