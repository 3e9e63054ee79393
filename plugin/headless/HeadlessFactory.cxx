#include "HeadlessFactory.h"

#include <cstdlib>
#include <string>

#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkVersion.h>

#include "../vtkShadowCompat.h"
#include "vtkHeadlessRenderWindow.h"

namespace shadow
{

namespace
{

/// Has no events but those that are invoked on it: Start() returns at once. Without a server VTK's interactors of X end
/// the program, before 9.4 when they are initialised, later when they are told to end.
class HeadlessInteractor : public vtkRenderWindowInteractor
{
public:
  static HeadlessInteractor* New();
  vtkTypeMacro(HeadlessInteractor, vtkRenderWindowInteractor);
};

vtkStandardNewMacro(HeadlessInteractor);

/// Of the window system that VTK was built for: its interactors ask no other.
bool hasDisplay()
{
  const vtkNew<vtkRenderWindowInteractor> interactor;
  const char* value =
      std::getenv(interactor->IsA("vtkWaylandRenderWindowInteractor") ? "WAYLAND_DISPLAY" : "DISPLAY");
  return value != nullptr && *value != '\0';
}

/// VTK's windows draw by the GL that ours are told to: when one of EGL's goes, OSMesa's contexts draw no more.
void chooseForVtk()
{
  const char* chosen = std::getenv("VTKSHADOW_HEADLESS");
  if (VTKSHADOW_VTK_DRAWS_HEADLESS && !hasDisplay() && chosen != nullptr && std::string(chosen) == "osmesa")
  {
    setenv("VTK_DEFAULT_OPENGL_WINDOW", "vtkOSOpenGLRenderWindow", 0);
  }
}

VTK_CREATE_CREATE_FUNCTION(vtkHeadlessRenderWindow)
VTK_CREATE_CREATE_FUNCTION(HeadlessInteractor)

class HeadlessFactory : public vtkObjectFactory
{
public:
  static HeadlessFactory* New();
  vtkTypeMacro(HeadlessFactory, vtkObjectFactory);

  const char* GetVTKSourceVersion() override { return VTK_SOURCE_VERSION; }
  const char* GetDescription() override { return "Windows that need no display"; }

protected:
  HeadlessFactory()
  {
    if (!VTKSHADOW_VTK_DRAWS_HEADLESS)
    {
      this->override("vtkRenderWindow", "vtkHeadlessRenderWindow", vtkObjectFactoryCreatevtkHeadlessRenderWindow);
    }
    if (!VTKSHADOW_VTK_DRAWS_HEADLESS || !hasDisplay())
    {
      this->override("vtkRenderWindowInteractor", "HeadlessInteractor", vtkObjectFactoryCreateHeadlessInteractor);
    }
  }

private:
  void override(const char* name, const char* with, CreateFunction create)
  {
    // The first factory that has a class is asked: earlier ones may have it no more.
    SetAllEnableFlags(0, name);
    this->RegisterOverride(name, with, this->GetDescription(), 1, create);
  }
};

vtkStandardNewMacro(HeadlessFactory);

} // namespace

void registerHeadlessFactory()
{
  static const bool registered = []
  {
    chooseForVtk();
    vtkNew<HeadlessFactory> factory;
    vtkObjectFactory::RegisterFactory(factory);
    return true;
  }();
  static_cast<void>(registered);
}

} // namespace shadow
