#include "vtkHeadlessRenderWindow.h"

#include <functional>
#include <vector>

#include <vtkObjectFactory.h>

#include "../vtkShadowCompat.h"
#include "GLFunctions.h"
#include "HeadlessContext.h"

class vtkHeadlessRenderWindow::vtkInternals
{
public:
  std::string Error; ///< why there is no context; before it, which fills it in
  std::unique_ptr<shadow::HeadlessContext> Context = shadow::makeHeadlessContext(this->Error);
  std::vector<std::function<void()>> Pushed; ///< each makes current what was so before a push
  bool Reported = false;
};

#if VTKSHADOW_WINDOW_LOADS_SYMBOLS
namespace
{

vtkShadowGLFunction loadSymbol(void* /*unused*/, const char* name)
{
  return vtkShadowGetGLFunction(name);
}

} // namespace
#endif

vtkStandardNewMacro(vtkHeadlessRenderWindow);

//------------------------------------------------------------------------------
vtkHeadlessRenderWindow::vtkHeadlessRenderWindow() : Internals(new vtkInternals)
{
#if VTKSHADOW_WINDOW_LOADS_SYMBOLS
  this->SetOpenGLSymbolLoader(&loadSymbol, nullptr);
#endif
  this->SetReadyForRendering(this->IsUsable());
  this->SetIsCurrent(this->IsUsable());
  this->SetIsDirect(0);
  this->SetSupportsOpenGL(this->IsUsable() ? 1 : 0);
  // The picture stays in VTK's own framebuffer, where vtkWindowToImageFilter reads it.
  this->SetFrameBlitModeToNoBlit();
  this->SetOwnContext(1);
  this->SetMultiSamples(0);
  this->SetSize(300, 300);
}

//------------------------------------------------------------------------------
vtkHeadlessRenderWindow::~vtkHeadlessRenderWindow()
{
  // While the context is still there: renderers and the window give back what they hold in it.
  if (this->IsUsable())
  {
    this->PushContext();
    this->Finalize();
    this->PopContext();
  }
}

//------------------------------------------------------------------------------
void vtkHeadlessRenderWindow::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Usable: " << this->IsUsable() << "\n";
  os << indent << "Backend: " << this->GetBackend() << "\n";
}

//------------------------------------------------------------------------------
bool vtkHeadlessRenderWindow::IsUsable() const
{
  return this->Internals != nullptr && this->Internals->Context != nullptr;
}

//------------------------------------------------------------------------------
std::string vtkHeadlessRenderWindow::GetBackend() const
{
  return this->IsUsable() ? this->Internals->Context->getDescription() : "";
}

//------------------------------------------------------------------------------
void vtkHeadlessRenderWindow::Render()
{
  // The superclass loads the GL functions before it makes the context current.
  this->MakeCurrent();
  this->Superclass::Render();
}

//------------------------------------------------------------------------------
void vtkHeadlessRenderWindow::MakeCurrent()
{
  if ((!this->IsUsable() || !this->Internals->Context->makeCurrent()) && !this->Internals->Reported)
  {
    this->Internals->Reported = true;
    vtkErrorMacro(<< (this->IsUsable() ? "The GL refuses its context." : this->Internals->Error));
  }
}

//------------------------------------------------------------------------------
bool vtkHeadlessRenderWindow::IsCurrent()
{
  return this->IsUsable() && this->Internals->Context->isCurrent();
}

//------------------------------------------------------------------------------
void vtkHeadlessRenderWindow::PushContext()
{
  this->Internals->Pushed.push_back(this->IsUsable() ? this->Internals->Context->rememberCurrent() : [] {});
  this->MakeCurrent();
}

//------------------------------------------------------------------------------
void vtkHeadlessRenderWindow::PopContext()
{
  if (!this->Internals->Pushed.empty())
  {
    this->Internals->Pushed.back()();
    this->Internals->Pushed.pop_back();
  }
}
