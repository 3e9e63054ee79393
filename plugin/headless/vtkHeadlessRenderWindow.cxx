#include "vtkHeadlessRenderWindow.h"

#include <vtkObjectFactory.h>

#include "../vtkShadowCompat.h"
#include "OSMesaContext.h"

class vtkHeadlessRenderWindow::vtkInternals
{
public:
  shadow::OSMesaContext Context;
  bool Reported = false;
};

vtkStandardNewMacro(vtkHeadlessRenderWindow);

//------------------------------------------------------------------------------
vtkHeadlessRenderWindow::vtkHeadlessRenderWindow() : Internals(new vtkInternals)
{
#if VTKSHADOW_WINDOW_LOADS_SYMBOLS
  this->SetOpenGLSymbolLoader(&shadow::OSMesaContext::getFunction, nullptr);
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
    this->MakeCurrent();
    this->Finalize();
  }
}

//------------------------------------------------------------------------------
void vtkHeadlessRenderWindow::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Usable: " << this->IsUsable() << "\n";
}

//------------------------------------------------------------------------------
bool vtkHeadlessRenderWindow::IsUsable() const
{
  return this->Internals != nullptr && this->Internals->Context.isUsable();
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
  // The buffer behind the context is never shown; a small one keeps memory low.
  const int size = 16;
  if (!this->Internals->Context.makeCurrent(size, size) && !this->Internals->Reported)
  {
    this->Internals->Reported = true;
    vtkErrorMacro("OSMesa gives no OpenGL 3.2 core context.");
  }
}

//------------------------------------------------------------------------------
bool vtkHeadlessRenderWindow::IsCurrent()
{
  return this->Internals != nullptr && this->Internals->Context.isCurrent();
}
