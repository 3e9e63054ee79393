#include "EGLNeighbour.h"

#include <stdexcept>

#include <dlfcn.h>

#if __has_include(<vtkEGLRenderWindow.h>)
#define SHADOW_HAS_VTK_EGL
#include <vtkEGLRenderWindow.h>
#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>
#endif

#include "EGLFunctions.h"

namespace shadow::test
{

namespace
{

using egl::Functions;

std::vector<egl::Device> listDevices()
{
  const Functions& functions = Functions::get();
  int count = 0;
  if (functions.queryDevices == nullptr || functions.queryDevices(0, nullptr, &count) == 0)
  {
    return {};
  }
  std::vector<egl::Device> devices(static_cast<std::size_t>(count));
  functions.queryDevices(count, devices.data(), &count);
  return devices;
}

/// Opens displays the way most programs do, without attributes.
class Program final : public EGLNeighbour
{
public:
  /// @throws std::runtime_error where the platform does not draw
  Program(unsigned int platform, egl::Device device)
      : display(Functions::get().getPlatformDisplay(platform, device, nullptr))
  {
    const Functions& functions = Functions::get();
    const int wanted[] = {egl::SurfaceType, egl::PbufferBit, egl::RenderableType, egl::OpenGLBit, egl::None};
    const int size[] = {egl::Width, 8, egl::Height, 8, egl::None};
    egl::Config config = nullptr;
    int count = 0;
    if (functions.initialize(this->display, nullptr, nullptr) == 0 || functions.bindAPI(egl::OpenGLApi) == 0 ||
        functions.chooseConfig(this->display, wanted, &config, 1, &count) == 0 || count == 0)
    {
      throw std::runtime_error("this platform does not draw");
    }
    this->surface = functions.createPbufferSurface(this->display, config, size);
    this->context = functions.createContext(this->display, config, nullptr, nullptr);
  }

  ~Program() override
  {
    // Whoever was current is so no more, as when a window gives back what it holds.
    this->draws();
    Functions::get().makeCurrent(this->display, nullptr, nullptr, nullptr);
    using Terminate = unsigned int (*)(egl::Display);
    reinterpret_cast<Terminate>(dlsym(dlopen("libEGL.so.1", RTLD_NOW), "eglTerminate"))(this->display);
  }

  bool draws() override
  {
    return Functions::get().makeCurrent(this->display, this->surface, this->surface, this->context) != 0;
  }

private:
  egl::Display display;
  egl::Surface surface = nullptr;
  egl::Context context = nullptr;
};

std::unique_ptr<EGLNeighbour> openProgram(unsigned int platform, egl::Device device)
{
  try
  {
    return std::make_unique<Program>(platform, device);
  }
  catch (const std::runtime_error&)
  {
    return nullptr;
  }
}

std::unique_ptr<EGLNeighbour> openDevice(int index)
{
  return openProgram(egl::PlatformDevice, listDevices()[static_cast<std::size_t>(index)]);
}

std::unique_ptr<EGLNeighbour> openSurfaceless(int /*unused*/)
{
  return openProgram(egl::PlatformSurfaceless, nullptr);
}

#ifdef SHADOW_HAS_VTK_EGL
class VtkWindow final : public EGLNeighbour
{
public:
  VtkWindow()
  {
    this->window->SetShowWindow(false);
    this->window->SetSize(20, 20);
    this->renderer->SetBackground(0.2, 0.4, 0.6);
    this->window->AddRenderer(this->renderer);
  }

  bool draws() override
  {
    vtkNew<vtkUnsignedCharArray> pixels;
    this->window->Render();
    this->window->GetPixelData(10, 10, 10, 10, 0, pixels, 0);
    return pixels->GetNumberOfValues() == 3 && pixels->GetValue(0) == 51 && pixels->GetValue(1) == 102 &&
           pixels->GetValue(2) == 153;
  }

private:
  vtkNew<vtkEGLRenderWindow> window;
  vtkNew<vtkRenderer> renderer;
};

std::unique_ptr<EGLNeighbour> openVtkWindow(int /*unused*/)
{
  return std::make_unique<VtkWindow>();
}
#endif

} // namespace

std::vector<EGLNeighbourKind> listEGLNeighbours()
{
  std::vector<EGLNeighbourKind> kinds;
#ifdef SHADOW_HAS_VTK_EGL
  kinds.push_back({"vtkEGLRenderWindow", &openVtkWindow, 0});
#endif
  const int devices = static_cast<int>(listDevices().size());
  for (int i = 0; i < devices; ++i)
  {
    kinds.push_back({"device " + std::to_string(i), &openDevice, i});
  }
  if (Functions::get().hasClientExtension("EGL_MESA_platform_surfaceless"))
  {
    kinds.push_back({"without a surface", &openSurfaceless, 0});
  }
  return kinds;
}

} // namespace shadow::test
