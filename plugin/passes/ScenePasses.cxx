#include "ScenePasses.h"

#include <algorithm>

#include <vtkCamera.h>
#include <vtkHiddenLineRemovalPass.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLRenderer.h>
#include <vtkOpenGLState.h>
#include <vtkProp.h>
#include <vtkRenderPass.h>
#include <vtkRenderState.h>

#include "OpenGL.h"
#include "PassScope.h"
#include "RendererAccess.h"

namespace shadow
{

namespace
{

vtkOpenGLRenderer* rendererOf(const vtkRenderState* s)
{
  return static_cast<vtkOpenGLRenderer*>(s->GetRenderer());
}

/// Has the renderer draw what is opaque, as it does without a pass.
class OpaqueByRenderer : public vtkRenderPass
{
public:
  static OpaqueByRenderer* New();
  vtkTypeMacro(OpaqueByRenderer, vtkRenderPass);

  void Render(const vtkRenderState* s) override
  {
    vtkOpenGLRenderer* renderer = rendererOf(s);
    const int before = renderer->GetNumberOfPropsRendered();
    renderer->DeviceRenderOpaqueGeometry(s->GetFrameBuffer());
    this->NumberOfRenderedProps = renderer->GetNumberOfPropsRendered() - before;
  }
};
vtkStandardNewMacro(OpaqueByRenderer);

/// Whether the framebuffer that is bound is the window's own, and not one of a pass above.
bool drawsIntoWindow(vtkOpenGLRenderWindow* window)
{
  GLint bound = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
  vtkOpenGLFramebufferObject* own = window->GetRenderFramebuffer();
  return own == nullptr || own->GetFBOIndex() == static_cast<unsigned int>(bound);
}

/// Sets viewport and scissor: the renderer's in the window, or all of a framebuffer that a pass above has
/// bound, which tells its size with the state or has set the viewport.
void setWholeView(vtkOpenGLRenderer* renderer, vtkOpenGLRenderWindow* window, const vtkRenderState* s)
{
  vtkOpenGLState* state = window->GetState();
  int view[4] = {0, 0, 0, 0};
  if (drawsIntoWindow(window))
  {
    renderer->GetTiledSizeAndOrigin(&view[2], &view[3], &view[0], &view[1]);
  }
  else if (vtkFrameBufferObjectBase* framebuffer = s->GetFrameBuffer())
  {
    framebuffer->GetLastSize(view[2], view[3]);
  }
  else
  {
    state->vtkglGetIntegerv(GL_VIEWPORT, view);
  }
  state->vtkglViewport(view[0], view[1], view[2], view[3]);
  state->vtkglEnable(GL_SCISSOR_TEST);
  state->vtkglScissor(view[0], view[1], view[2], view[3]);
}

int drawPart(vtkRenderPass* pass, const vtkRenderState* s)
{
  pass->Render(s);
  return pass->GetNumberOfRenderedProps();
}

} // namespace

ScenePasses::ScenePasses() : opaqueByRenderer(vtkSmartPointer<OpaqueByRenderer>::New()) {}

bool ScenePasses::renderInstead(vtkRenderPass* pass, bool complete, vtkOpenGLRenderer* renderer,
                                const vtkRenderState* s, int& rendered)
{
  if (!this->hasCamera && this->drawWithCamera(pass, complete, renderer, s))
  {
    return true;
  }
  if (renderer->GetSelector() != nullptr)
  {
    rendered = RendererAccess::select(renderer, s);
    return true;
  }
  return false;
}

bool ScenePasses::drawWithCamera(vtkRenderPass* pass, bool complete, vtkOpenGLRenderer* renderer,
                                 const vtkRenderState* s)
{
  const bool isRenderers = renderer->GetPass() == pass;
  const CameraNeed need = isRenderers ? CameraNeed::All : findCameraNeed(renderer, pass);
  if (need == CameraNeed::None)
  {
    return false;
  }
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  vtkOpenGLState* state = window->GetState();
  const vtkOpenGLState::ScopedglViewport viewport(state);
  const vtkOpenGLState::ScopedglScissor scissor(state);
  const vtkOpenGLState::ScopedglEnableDisable scissorTest(state, GL_SCISSOR_TEST);
  const bool erases = need == CameraNeed::All && (complete || isRenderers);
  if (erases && drawsIntoWindow(window))
  {
    // Viewport, scissor, background, and the window's stereo.
    renderer->GetActiveCamera()->Render(renderer);
  }
  else
  {
    setWholeView(renderer, window, s);
    if (erases && window->GetErase() != 0 && renderer->GetErase() != 0)
    {
      renderer->Clear();
    }
  }
  if (isRenderers)
  {
    RendererAccess::setNumberOfPropsRendered(renderer, 0);
  }
  this->hasCamera = true;
  pass->Render(s);
  this->hasCamera = false;
  if (isRenderers)
  {
    RendererAccess::setNumberOfPropsRendered(renderer, pass->GetNumberOfRenderedProps());
  }
  return true;
}

vtkRenderPass* ScenePasses::chooseOpaque(const vtkRenderState* s, bool complete) const
{
  vtkOpenGLRenderer* renderer = rendererOf(s);
  const bool hidesLines =
      renderer->GetUseHiddenLineRemoval() &&
      vtkHiddenLineRemovalPass::WireframePropsExist(s->GetPropArray(), s->GetPropArrayCount());
  const bool wantsMore = hidesLines || renderer->GetUseSSAO();
  // Into a framebuffer of another pass the renderer's own would not fit.
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  return complete && wantsMore && drawsIntoWindow(window) && RendererAccess::hasAllProps(renderer, s)
             ? this->opaqueByRenderer.GetPointer()
             : this->opaque.GetPointer();
}

int ScenePasses::drawLights(const vtkRenderState* s)
{
  return drawPart(this->lights, s);
}

int ScenePasses::drawRest(const vtkRenderState* s)
{
  vtkOpenGLRenderer* renderer = rendererOf(s);
  vtkProp** props = s->GetPropArray();
  const bool hasTranslucent = std::any_of(props, props + s->GetPropArrayCount(), [](vtkProp* prop)
                                          { return prop->HasTranslucentPolygonalGeometry() != 0; });
  const bool byRenderer = hasTranslucent && RendererAccess::hasAllProps(renderer, s);
  int rendered = 0;
  if (byRenderer)
  {
    const int before = renderer->GetNumberOfPropsRendered();
    renderer->DeviceRenderTranslucentPolygonalGeometry(s->GetFrameBuffer());
    rendered = renderer->GetNumberOfPropsRendered() - before;
  }
  else if (hasTranslucent)
  {
    rendered = drawPart(this->translucent, s);
  }
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  if (renderer->GetUseFXAA() && drawsIntoWindow(window))
  {
    vtkOpenGLFXAAFilter* filter = RendererAccess::getFXAAFilter(renderer);
    if (renderer->GetFXAAOptions() != nullptr)
    {
      filter->UpdateConfiguration(renderer->GetFXAAOptions());
    }
    filter->Execute(renderer);
  }
  // The renderer peels volumes with what is translucent, if it is told to.
  if (!byRenderer || !renderer->GetUseDepthPeeling() || !renderer->GetUseDepthPeelingForVolumes())
  {
    rendered += drawPart(this->volumetric, s);
  }
  return rendered + drawPart(this->overlay, s);
}

void ScenePasses::ReleaseGraphicsResources(vtkWindow* window)
{
  for (vtkRenderPass* pass :
       {static_cast<vtkRenderPass*>(this->lights), static_cast<vtkRenderPass*>(this->opaque),
        static_cast<vtkRenderPass*>(this->translucent), static_cast<vtkRenderPass*>(this->volumetric),
        static_cast<vtkRenderPass*>(this->overlay)})
  {
    pass->ReleaseGraphicsResources(window);
  }
}

} // namespace shadow
