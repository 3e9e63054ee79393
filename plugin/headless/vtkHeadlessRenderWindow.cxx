#include "vtkHeadlessRenderWindow.h"

#include <functional>
#include <vector>

#include <vtkObjectFactory.h>

#include "../vtkShadowCompat.h"
#include "GLFunctions.h"
#include "HeadlessContext.h"
#include "HeadlessFactory.h"

class vtkHeadlessRenderWindow::vtkInternals
{
public:
  std::string Error; ///< why there is no context; before it, which fills it in
  // Two windows of one program draw by one GL, VTK's own among them.
  std::unique_ptr<shadow::HeadlessContext> Context =
      shadow::makeHeadlessContext(VTKSHADOW_VTK_DRAWS_HEADLESS ? "egl" : "osmesa", this->Error);
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
void vtkHeadlessRenderWindow::OverrideRenderWindow()
{
  shadow::registerHeadlessFactory();
}

//------------------------------------------------------------------------------
bool vtkHeadlessRenderWindow::IsUsable() const
{
  return this->Internals != nullptr && this->Internals->Context != nullptr;
}

//------------------------------------------------------------------------------
std::string vtkHeadlessRenderWindow::GetStatusMessage() const
{
  return this->IsUsable() ? "" : this->Internals->Error;
}

//------------------------------------------------------------------------------
std::string vtkHeadlessRenderWindow::GetBackend() const
{
  return this->IsUsable() ? this->Internals->Context->getDescription() : "";
}

//------------------------------------------------------------------------------
void vtkHeadlessRenderWindow::Initialize()
{
  // What is asked of the window before its first picture needs the GL functions as well.
  this->MakeCurrent();
  if (!this->Initialized && this->IsCurrent())
  {
    this->OpenGLInit();
  }
}

//------------------------------------------------------------------------------
void vtkHeadlessRenderWindow::Start()
{
  this->Initialize();
  if (this->IsUsable())
  {
    this->Superclass::Start();
  }
}

//------------------------------------------------------------------------------
void vtkHeadlessRenderWindow::Frame()
{
  if (this->IsUsable())
  {
    this->Superclass::Frame();
  }
}

//------------------------------------------------------------------------------
int vtkHeadlessRenderWindow::GetZbufferData(int x1, int y1, int x2, int y2, float* z)
{
  return this->IsUsable() ? this->Superclass::GetZbufferData(x1, y1, x2, y2, z) : VTK_ERROR;
}

//------------------------------------------------------------------------------
void vtkHeadlessRenderWindow::Render()
{
  // The superclass loads the GL functions before it makes the context current.
  this->MakeCurrent();
  this->Superclass::Render();
}

//------------------------------------------------------------------------------
const char* vtkHeadlessRenderWindow::ReportCapabilities()
{
  this->Initialize();
  return this->IsCurrent() ? this->Superclass::ReportCapabilities() : "no OpenGL\n";
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
