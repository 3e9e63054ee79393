#include "vtkShadowVolumePass.h"

#include <algorithm>

#include <vtkImageData.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLRenderer.h>
#include <vtkOpenGLState.h>
#include <vtkProp.h>
#include <vtkRenderState.h>
#include <vtkShaderProgram.h>

#include "OpenGL.h"
#include "PassScope.h"
#include "PrimitiveKind.h"
#include "ShadowPassInternals.h"
#include "Stopwatch.h"

vtkStandardNewMacro(vtkShadowVolumePass);

//------------------------------------------------------------------------------
vtkShadowVolumePass::vtkShadowVolumePass() : Internals(new vtkInternals) {}

//------------------------------------------------------------------------------
vtkShadowVolumePass::~vtkShadowVolumePass() = default;

//------------------------------------------------------------------------------
void vtkShadowVolumePass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "StencilMethod: " << this->StencilMethod << "\n";
  os << indent << "CountBuffer: " << this->CountBuffer << "\n";
  os << indent << "SilhouetteMethod: " << this->SilhouetteMethod << "\n";
  os << indent << "CoplanarTolerance: " << this->CoplanarTolerance << "\n";
  os << indent << "Compositing: " << this->Compositing << "\n";
  os << indent << "Scope: " << this->Scope << "\n";
  os << indent << "Samples: " << this->Samples << "\n";
  os << indent << "ShadowIntensity: " << this->ShadowIntensity << "\n";
  os << indent << "WeldTolerance: " << this->WeldTolerance << "\n";
  os << indent << "Savings: " << this->Savings << "\n";
  os << indent << "MeasureStages: " << this->MeasureStages << "\n";
  os << indent << "Status: " << this->GetStatus() << "\n";
}

//------------------------------------------------------------------------------
void vtkShadowVolumePass::Render(const vtkRenderState* s)
{
  this->NumberOfRenderedProps = 0;
  auto* renderer = vtkOpenGLRenderer::SafeDownCast(s->GetRenderer());
  auto* window =
      renderer != nullptr ? vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow()) : nullptr;
  if (window == nullptr)
  {
    vtkErrorMacro("needs a renderer in an OpenGL render window.");
    return;
  }
  if (shadow::hasNoPixels(renderer))
  {
    this->Internals->Status = STATUS_OK;
    this->Internals->Message.clear();
    this->Internals->Remark.clear();
    return;
  }
  if (this->Internals->Passes.renderInstead(this, this->Scope != SCOPE_OPAQUE, renderer, s,
                                            this->NumberOfRenderedProps))
  {
    return;
  }

  const bool complete = this->Scope == SCOPE_COMPLETE ||
                        (this->Scope == SCOPE_AUTO && !shadow::othersDrawTheRest(renderer, this));
  shadow::ScenePasses& passes = this->Internals->Passes;
  if (complete)
  {
    this->NumberOfRenderedProps += passes.drawLights(s);
  }
  const bool shadowed = this->Internals->PrepareMask(this, s, renderer, window);
  vtkRenderPass* opaque = passes.chooseOpaque(s, complete);
  if (shadowed)
  {
    this->RenderShadowed(s, opaque);
  }
  else
  {
    this->RenderPart(opaque, s);
  }
  if (this->Internals->AfterOpaque)
  {
    this->Internals->AfterOpaque();
  }
  if (complete)
  {
    this->NumberOfRenderedProps += passes.drawRest(s);
  }
  if (this->Internals->Current->Messages.isNews(this->Internals->Message))
  {
    vtkWarningMacro(<< this->Internals->Message);
  }
}

//------------------------------------------------------------------------------
void vtkShadowVolumePass::RenderPart(vtkRenderPass* pass, const vtkRenderState* s)
{
  pass->Render(s);
  this->NumberOfRenderedProps += pass->GetNumberOfRenderedProps();
}

//------------------------------------------------------------------------------
void vtkShadowVolumePass::RenderShadowed(const vtkRenderState* s, vtkRenderPass* opaque)
{
  vtkInternals& internals = *this->Internals;
  shadow::LightingHook& hook = internals.Hook;
  vtkOpenGLState* state = internals.Current->Context.getWindow()->GetState();
  const shadow::Stopwatch stage;

  const vtkOpenGLState::ScopedglActiveTexture activeTexture(state);
  const vtkOpenGLState::ScopedglEnableDisable culling(state, GL_CULL_FACE);
  hook.begin(state, *internals.Current->Effect, internals.Current->View);
  this->PreRender(s);
  if (this->Compositing == COMPOSITING_MASK || !internals.BeginLights(opaque))
  {
    hook.pass = shadow::LightingHook::AllLights;
    this->RenderPart(opaque, s);
  }
  else
  {
    hook.pass = shadow::LightingHook::AmbientOnly;
    this->RenderPart(opaque, s);
    internals.AddLights(s, opaque);
  }
  this->PostRender(s);
  hook.end(state);
  if (this->MeasureStages)
  {
    glFinish();
  }
  internals.LightingMilliseconds = stage.getMilliseconds();
}

//------------------------------------------------------------------------------
bool vtkShadowVolumePass::PostReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
                                                  std::string& fragmentShader, vtkAbstractMapper* mapper,
                                                  vtkProp* prop)
{
  const auto* current = this->Internals->Current;
  const bool mirrored =
      current != nullptr && current->Builder.isMirrored(prop) && shadow::drawsFaces(mapper);
  if (!this->Internals->Hook.substitute(fragmentShader, mirrored))
  {
    // VTK builds a shader once; the message stays with it.
    const std::string message = std::string("the shader of a ") + prop->GetClassName() +
                                " has lighting that shadows cannot be put into; it is drawn without";
    if (this->Internals->Current != nullptr)
    {
      this->Internals->Current->ShaderMessages.insert(message);
    }
    this->Internals->AddMessage(message);
  }
  return this->Superclass::PostReplaceShaderValues(vertexShader, geometryShader, fragmentShader, mapper,
                                                   prop);
}

//------------------------------------------------------------------------------
bool vtkShadowVolumePass::SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper,
                                              vtkProp* prop, vtkOpenGLVertexArrayObject* VAO)
{
  this->Internals->Hook.setUniforms(this->Internals->Current->Context.getWindow()->GetState(), program);
  this->Internals->SetHiddenSide(prop);
  this->Internals->BlendLight(true);
  return this->Superclass::SetShaderParameters(program, mapper, prop, VAO);
}

//------------------------------------------------------------------------------
vtkMTimeType vtkShadowVolumePass::GetShaderStageMTime()
{
  const auto* current = this->Internals->Current;
  return current != nullptr ? current->ShaderTime.GetMTime() : 0;
}

//------------------------------------------------------------------------------
void vtkShadowVolumePass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Internals->Release(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
void vtkShadowVolumePass::SetCasting(vtkProp* prop, bool casting)
{
  if (prop == nullptr)
  {
    vtkErrorMacro("SetCasting needs a prop.");
    return;
  }
  if (casting != this->GetCasting(prop))
  {
    this->Internals->NotCasting.set(prop, !casting);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
bool vtkShadowVolumePass::GetCasting(vtkProp* prop)
{
  return !this->Internals->NotCasting.has(prop);
}

//------------------------------------------------------------------------------
bool vtkShadowVolumePass::GetShadowMask(int light, vtkImageData* image)
{
  const auto& current = this->Internals->Current;
  if (image == nullptr || current == nullptr || current->Context.getWindow() == nullptr ||
      this->GetStatus() == STATUS_NOT_SUPPORTED)
  {
    vtkErrorMacro("GetShadowMask needs an image and a rendering with shadows before it.");
    return false;
  }
  if (light < 0 || light >= static_cast<int>(this->Internals->Hook.strength.size()))
  {
    vtkErrorMacro("there is no light " << light << " that is switched on.");
    return false;
  }
  shadow::ShadowTarget& target = current->Effect->getTarget();
  if (target.getWidth() == 0 || current->Context.isLost())
  {
    vtkErrorMacro("the shadow mask has been released; render again.");
    return false;
  }
  const shadow::ContextScope scope(current->Context.getWindow());
  image->SetDimensions(target.getWidth(), target.getHeight(), 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  auto* pixels = static_cast<unsigned char*>(image->GetScalarPointer());
  if (light >= shadow::maximumLights)
  {
    std::fill_n(pixels, image->GetNumberOfPoints(), static_cast<unsigned char>(255));
    image->Modified();
    return true;
  }
  const std::vector<unsigned char> mask = target.readMask(current->Context.getWindow(), light);
  std::copy(mask.begin(), mask.end(), pixels);
  image->Modified();
  return true;
}
