#ifndef PassContext_h
#define PassContext_h

#include <functional>
#include <map>

#include <vtkCameraPass.h>
#include <vtkLightsPass.h>
#include <vtkNew.h>
#include <vtkOpaquePass.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLRenderer.h>
#include <vtkOverlayPass.h>
#include <vtkTextureObject.h>
#include <vtkTranslucentPass.h>
#include <vtkVolumetricPass.h>
#include <vtkWeakPointer.h>

#include "View.h"

class vtkProp;
class vtkWindow;

namespace shadow
{

/// The renderer and window that GL objects of a pass were made for, and whether these are still there.
class PassContext
{
public:
  PassContext(vtkOpenGLRenderer* theRenderer, vtkOpenGLRenderWindow* theWindow)
      : renderer(theRenderer), window(theWindow)
  {
  }

  vtkOpenGLRenderer* getRenderer() const { return this->renderer; }
  vtkOpenGLRenderWindow* getWindow() const { return this->window; }

  /// True when GL objects made since acquire() are gone with their context.
  bool isLost() const { return this->window == nullptr || this->sentinel->GetHandle() == 0; }

  /// Makes the context current.
  /// @param forget  called when it is not the one of the last time: GL objects are to be forgotten
  void acquire(const std::function<void()>& forget);

  /// Has @p free free the GL objects, with the context current, or forget them when it is lost.
  void release(const std::function<void(bool contextLost)>& free);

private:
  vtkWeakPointer<vtkOpenGLRenderer> renderer;
  vtkWeakPointer<vtkOpenGLRenderWindow> window;
  /// One texel that VTK frees with the window's context: tells whether our own GL objects are still there,
  /// also when the pass has been detached and nobody tells it.
  vtkNew<vtkTextureObject> sentinel;
};

/// The matrices and the viewport that VTK is about to draw with.
View currentView(vtkOpenGLRenderer* renderer, vtkOpenGLRenderWindow* window);

/// What VTK draws a scene with, one pass for each part.
struct ScenePasses
{
  vtkNew<vtkCameraPass> camera;
  vtkNew<vtkLightsPass> lights;
  vtkNew<vtkOpaquePass> opaque;
  vtkNew<vtkTranslucentPass> translucent;
  vtkNew<vtkVolumetricPass> volumetric;
  vtkNew<vtkOverlayPass> overlay;

  void ReleaseGraphicsResources(vtkWindow* window);
};

/// Props that something has been switched off for. They are not kept alive.
class PropExclusions
{
public:
  void set(vtkProp* prop, bool excluded);
  bool has(vtkProp* prop) const;

private:
  std::map<vtkProp*, vtkWeakPointer<vtkProp>> props;
};

} // namespace shadow

#endif
