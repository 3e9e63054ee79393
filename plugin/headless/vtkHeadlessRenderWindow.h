/**
 * @class   vtkHeadlessRenderWindow
 * @brief   a render window without a display, drawn by OSMesa
 *
 * Owns an OSMesa core-profile context and draws into it in software. Programs that use it must let the
 * symbols of libvtkShadowGLX and libOSMesa come before those of the system's GL: link the CMake target
 * `vtkShadow::HeadlessFirst`, or in Python `import vtkshadow.headless` before anything of VTK.
 *
 * @par Use
 * `vtkNew<vtkHeadlessRenderWindow> window; window->SetSize(1280, 720); window->AddRenderer(renderer);
 * window->Render();` then vtkWindowToImageFilter (ReadFrontBufferOff) or
 * vtkRenderWindow::GetRGBACharPixelData as with any window.
 */
#ifndef vtkHeadlessRenderWindow_h
#define vtkHeadlessRenderWindow_h

#include "vtkGenericOpenGLRenderWindow.h"
#include "vtkShadowHeadlessModule.h" // for the export macro

#include <memory> // for std::unique_ptr

class VTKSHADOWHEADLESS_EXPORT vtkHeadlessRenderWindow : public vtkGenericOpenGLRenderWindow
{
public:
  static vtkHeadlessRenderWindow* New();
  vtkTypeMacro(vtkHeadlessRenderWindow, vtkGenericOpenGLRenderWindow);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * True when the OSMesa context is there and can be drawn into. False otherwise, after one vtkErrorMacro;
   * rendering then does nothing.
   */
  bool IsUsable() const;

  /**
   * Called by VTK.
   */
  void Render() override;
  void MakeCurrent() override;
  bool IsCurrent() override;

protected:
  vtkHeadlessRenderWindow();
  ~vtkHeadlessRenderWindow() override;

private:
  vtkHeadlessRenderWindow(const vtkHeadlessRenderWindow&) = delete;
  void operator=(const vtkHeadlessRenderWindow&) = delete;

  class vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
