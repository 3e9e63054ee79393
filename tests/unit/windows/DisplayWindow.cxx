#include "WindowUnderTest.h"

#include <cstdlib>

#include <vtkNew.h>

namespace shadow::test
{

namespace
{

/// VTK's windows never close the connection that they open, and a server takes 256.
void* openConnection()
{
  static const auto first = vtkSmartPointer<vtkRenderWindow>::New();
  first->Render();
  return first->GetGenericDisplayId();
}

} // namespace

vtkSmartPointer<vtkRenderWindow> makeWindow()
{
  static void* const connection = openConnection();
  const auto window = vtkSmartPointer<vtkRenderWindow>::New();
  window->SetDisplayId(connection);
  return window;
}

std::string whyThereIsNoWindow()
{
  const char* display = std::getenv("DISPLAY");
  if (display == nullptr || *display == '\0')
  {
    return "there is no X server: DISPLAY is not set (Debian: xvfb)";
  }
  vtkNew<vtkRenderWindow> window;
  return window->IsA("vtkXOpenGLRenderWindow") != 0
             ? ""
             : std::string("VTK opens a ") + window->GetClassName() + " and no window of X";
}

bool makeNoneCurrent()
{
  return false; // and VTK's window would not come back to it either
}

} // namespace shadow::test
