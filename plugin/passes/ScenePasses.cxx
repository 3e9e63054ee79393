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

/// Sets viewport and scissor for a framebuffer that a pass above has bound: it tells its size with the state, or has
/// set the viewport.
void setWholeFramebuffer(vtkOpenGLState* state, const vtkRenderState* s)
{
  int view[4] = {0, 0, 0, 0};
  if (vtkFrameBufferObjectBase* framebuffer = s->GetFrameBuffer())
  {
    framebuffer->GetLastSize(view[2], view[3]);
    state->vtkglViewport(view[0], view[1], view[2], view[3]);
  }
  else
  {
    state->vtkglGetIntegerv(GL_VIEWPORT, view);
  }
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

bool ScenePasses::renderInstead(vtkRenderPass* pass, vtkOpenGLRenderer* renderer, const vtkRenderState* s,
                                int& rendered)
{
  if (!this->hasCamera && this->drawWithCamera(pass, renderer, s))
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

bool ScenePasses::drawWithCamera(vtkRenderPass* pass, vtkOpenGLRenderer* renderer, const vtkRenderState* s)
{
  const bool isRenderers = renderer->GetPass() == pass;
  if (!isRenderers && !needsCamera(renderer, pass))
  {
    return false;
  }
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  vtkOpenGLState* state = window->GetState();
  const vtkOpenGLState::ScopedglViewport viewport(state);
  const vtkOpenGLState::ScopedglScissor scissor(state);
  const vtkOpenGLState::ScopedglEnableDisable scissorTest(state, GL_SCISSOR_TEST);
  if (isRenderers || drawsIntoWindow(window))
  {
    // Viewport, scissor, background, and the window's stereo.
    renderer->GetActiveCamera()->Render(renderer);
  }
  else
  {
    setWholeFramebuffer(state, s);
    if (window->GetErase() != 0 && renderer->GetErase() != 0)
    {
      renderer->Clear();
    }
  }
  this->hasCamera = true;
  pass->Render(s);
  this->hasCamera = false;
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
  return complete && wantsMore && s->GetFrameBuffer() == nullptr && RendererAccess::hasAllProps(renderer, s)
             ? this->opaqueByRenderer.GetPointer()
             : this->opaque.GetPointer();
}

int ScenePasses::drawLights(const vtkRenderState* s)
{
  return drawPart(this->lights, s);
}

int ScenePasses::drawTranslucent(vtkOpenGLRenderer* renderer, const vtkRenderState* s)
{
  if (!RendererAccess::hasAllProps(renderer, s))
  {
    return drawPart(this->translucent, s);
  }
  const int before = renderer->GetNumberOfPropsRendered();
  renderer->DeviceRenderTranslucentPolygonalGeometry(s->GetFrameBuffer());
  return renderer->GetNumberOfPropsRendered() - before;
}

int ScenePasses::drawRest(const vtkRenderState* s)
{
  vtkOpenGLRenderer* renderer = rendererOf(s);
  vtkProp** props = s->GetPropArray();
  const bool hasTranslucent = std::any_of(props, props + s->GetPropArrayCount(), [](vtkProp* prop)
                                          { return prop->HasTranslucentPolygonalGeometry() != 0; });
  int rendered = hasTranslucent ? this->drawTranslucent(renderer, s) : 0;
  if (renderer->GetUseFXAA() && s->GetFrameBuffer() == nullptr)
  {
    vtkOpenGLFXAAFilter* filter = RendererAccess::getFXAAFilter(renderer);
    if (renderer->GetFXAAOptions() != nullptr)
    {
      filter->UpdateConfiguration(renderer->GetFXAAOptions());
    }
    filter->Execute(renderer);
  }
  // Volumes may have been peeled with the translucent props.
  if (!hasTranslucent || !renderer->GetUseDepthPeeling() || !renderer->GetUseDepthPeelingForVolumes())
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
