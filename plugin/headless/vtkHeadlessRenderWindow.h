/**
 * @class   vtkHeadlessRenderWindow
 * @brief   a render window without a display, drawn by OSMesa or through EGL
 *
 * The environment variable VTKSHADOW_HEADLESS chooses for the whole process: `osmesa` draws in software, `egl`
 * on the first GPU that EGL finds, or in software where there is none. Not set: the first of these that draws,
 * from VTK 9.4 on EGL before OSMesa, as VTK's own windows. Either library is loaded when the first window is
 * made. Programs that use it must let the symbols of libvtkShadowGLX come before those of the system's GL: link
 * the CMake target `vtkShadow::HeadlessFirst`, or in Python `import vtkshadow.headless` before anything of VTK.
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
#include <string> // for std::string

class VTKSHADOWHEADLESS_EXPORT vtkHeadlessRenderWindow : public vtkGenericOpenGLRenderWindow
{
public:
  static vtkHeadlessRenderWindow* New();
  vtkTypeMacro(vtkHeadlessRenderWindow, vtkGenericOpenGLRenderWindow);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * From now on vtkRenderWindow::New() gives a vtkHeadlessRenderWindow, and vtkRenderWindowInteractor::New() an
   * interactor whose Start() returns at once. For code that makes its windows itself. From VTK 9.4 on, whose own
   * windows need no display, it is the interactor only, and only where the environment names no display;
   * there VTKSHADOW_HEADLESS=osmesa goes for VTK's own windows as well, if it is called before the first of them.
   */
  static void OverrideRenderWindow();

  /**
   * True when the context is there and can be drawn into. Otherwise rendering and reading pixels do nothing, and
   * the first of them says why by vtkErrorMacro.
   */
  bool IsUsable() const;

  /**
   * Why the window is not usable. Empty when it is.
   */
  std::string GetStatusMessage() const;

  /**
   * What draws: "OSMesa", or EGL with its version, vendor and device. Empty when the window is not usable.
   */
  std::string GetBackend() const;

  /**
   * Called by VTK.
   */
  void Initialize() override;
  void Start() override;
  void Render() override;
  void Frame() override;
  using vtkGenericOpenGLRenderWindow::GetZbufferData;
  int GetZbufferData(int x1, int y1, int x2, int y2, float* z) override;
  const char* ReportCapabilities() override;
  void MakeCurrent() override;
  bool IsCurrent() override;

  /**
   * Called by VTK around what it frees in the window's context: what was current before the one is current
   * again after the other, also when that was no context. They nest.
   */
  void PushContext() override;
  void PopContext() override;

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
