#include "WindowUnderTest.h"

#include <vtkHeadlessRenderWindow.h>
#include <vtkNew.h>

namespace shadow::test
{

vtkSmartPointer<vtkRenderWindow> makeWindow()
{
  return vtkSmartPointer<vtkHeadlessRenderWindow>::New();
}

std::string whyThereIsNoWindow()
{
  vtkNew<vtkHeadlessRenderWindow> window;
  return window->IsUsable() ? "" : "the headless window is not usable";
}

bool makeNoneCurrent()
{
  // A context that is deleted while it is current leaves none.
  vtkNew<vtkHeadlessRenderWindow> window;
  window->MakeCurrent();
  return true;
}

} // namespace shadow::test
