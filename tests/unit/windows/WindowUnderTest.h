#pragma once

#include <string>

#include <vtkRenderWindow.h>
#include <vtkSmartPointer.h>

namespace shadow::test
{

/// Which kind of window a program tests is decided by what it links: HeadlessWindow.cxx or DisplayWindow.cxx.
vtkSmartPointer<vtkRenderWindow> makeWindow();

/// Why such a window cannot be opened here; empty when it can.
std::string whyThereIsNoWindow();

/// Has no context be current in this thread. @return false when the kind of window knows no way to
bool makeNoneCurrent();

} // namespace shadow::test
