#include "HeadlessFactory.h"

#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkVersion.h>

#include "vtkHeadlessRenderWindow.h"

namespace shadow
{

namespace
{

/// Has no events but those that are invoked on it: Start() returns at once. VTK's interactors of X end the program when
/// there is no server.
class HeadlessInteractor : public vtkRenderWindowInteractor
{
public:
  static HeadlessInteractor* New();
  vtkTypeMacro(HeadlessInteractor, vtkRenderWindowInteractor);
};

vtkStandardNewMacro(HeadlessInteractor);

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
    this->override("vtkRenderWindow", "vtkHeadlessRenderWindow", vtkObjectFactoryCreatevtkHeadlessRenderWindow);
    this->override("vtkRenderWindowInteractor", "HeadlessInteractor", vtkObjectFactoryCreateHeadlessInteractor);
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
    vtkNew<HeadlessFactory> factory;
    vtkObjectFactory::RegisterFactory(factory);
    return true;
  }();
  static_cast<void>(registered);
}

} // namespace shadow
