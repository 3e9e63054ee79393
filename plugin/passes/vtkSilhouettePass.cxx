#include "vtkSilhouettePass.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <set>

#include <vtkHardwareSelector.h>
#include <vtkImageData.h>
#include <vtkObjectFactory.h>
#include <vtkProp.h>
#include <vtkRenderState.h>
#include <vtkSmartPointer.h>

#include "OutlineEffect.h"
#include "PassContext.h"
#include "PassScope.h"
#include "SceneBuilder.h"
#include "Stopwatch.h"

/// What vtkSilhouettePass keeps out of its header.
class vtkSilhouettePass::vtkInternals
{
public:
  /// Everything that belongs to one renderer: a pass may serve several.
  struct RendererState
  {
    shadow::PassContext Context;
    shadow::SceneBuilder Builder;
    shadow::OutlineEffect Effect;

    RendererState(vtkOpenGLRenderer* renderer, vtkOpenGLRenderWindow* window) : Context(renderer, window) {}
    ~RendererState() { this->Release(); }
    void Release()
    {
      this->Context.release([this](bool contextLost) { this->Effect.release(contextLost); });
    }
  };

  /// @post its context is current
  RendererState& GetState(vtkOpenGLRenderer* renderer, vtkOpenGLRenderWindow* window);

  /// Mirrors the scene and draws its lines over what is there.
  void DrawLines(vtkSilhouettePass* self, vtkOpenGLRenderer* renderer, vtkOpenGLRenderWindow* window);

  const shadow::OutlineEffect::Statistics& GetStatistics() const
  {
    static const shadow::OutlineEffect::Statistics none;
    return this->Current != nullptr ? this->Current->Effect.getStatistics() : none;
  }

  vtkSmartPointer<vtkRenderPass> Delegate;
  shadow::ScenePasses Passes;
  shadow::PropExclusions NotOutlined;
  bool InsideCameraPass = false;
  std::map<vtkOpenGLRenderer*, std::unique_ptr<RendererState>> Renderers;
  RendererState* Current = nullptr; ///< of the last rendering
  int Status = STATUS_NOT_RENDERED;
  std::string Message;
  std::string ReportedMessage;
  std::set<shadow::CasterCuller::Skipped> Skipped;
  double SceneMilliseconds = 0.0;
};

vtkStandardNewMacro(vtkSilhouettePass);

//------------------------------------------------------------------------------
vtkSilhouettePass::vtkInternals::RendererState&
vtkSilhouettePass::vtkInternals::GetState(vtkOpenGLRenderer* renderer, vtkOpenGLRenderWindow* window)
{
  this->Current = nullptr;
  for (auto entry = this->Renderers.begin(); entry != this->Renderers.end();)
  {
    entry = entry->second->Context.getRenderer() == nullptr ? this->Renderers.erase(entry) : std::next(entry);
  }
  std::unique_ptr<RendererState>& state = this->Renderers[renderer];
  if (state == nullptr || state->Context.getWindow() != window)
  {
    state = std::make_unique<RendererState>(renderer, window);
  }
  state->Context.acquire([&state] { state->Effect.release(true); });
  this->Current = state.get();
  return *state;
}

//------------------------------------------------------------------------------
void vtkSilhouettePass::vtkInternals::DrawLines(vtkSilhouettePass* self, vtkOpenGLRenderer* renderer,
                                                vtkOpenGLRenderWindow* window)
{
  RendererState& state = this->GetState(renderer, window);
  this->Status = STATUS_OK;
  this->Message.clear();

  const shadow::Stopwatch stage;
  shadow::SceneBuilder::Settings sceneSettings;
  sceneSettings.weldTolerance = self->WeldTolerance;
  sceneSettings.weldsRounding = true; // a seam that nobody sees must not show as a border
  sceneSettings.isCasting = [this](vtkProp* prop) { return !this->NotOutlined.has(prop); };
  sceneSettings.product = "outline";
  state.Builder.update(renderer, sceneSettings, state.Effect);
  this->Skipped = state.Builder.getSkipped();
  this->SceneMilliseconds = stage.getMilliseconds();

  shadow::OutlineEffect::Settings settings;
  settings.technique = static_cast<shadow::LineTechnique>(self->Technique);
  settings.depthScale = self->DepthScale;
  settings.lineWidth = self->LineWidth;
  settings.silhouette = self->SilhouetteEdges;
  settings.border = self->BorderEdges;
  settings.crease = self->CreaseEdges;
  settings.featureAngle = self->FeatureAngle;
  settings.waitAfterStages = self->MeasureStages;
  shadow::OutlineEffect::Look look;
  look.color = {self->Color[0], self->Color[1], self->Color[2]};
  look.hiddenColor = {self->HiddenColor[0], self->HiddenColor[1], self->HiddenColor[2],
                      self->HiddenEdges ? self->HiddenOpacity : 0.0};
  look.smooth = self->Smooth;
  std::string error;
  if (!state.Effect.renderLines(window, shadow::currentView(renderer, window), settings, error) ||
      !state.Effect.blend(window, look, self->MeasureStages, error))
  {
    this->Status = STATUS_NOT_SUPPORTED;
    this->Message = error;
    return;
  }
  std::set<std::string> errors(state.Builder.getErrors().begin(), state.Builder.getErrors().end());
  errors.insert(state.Effect.getErrors().begin(), state.Effect.getErrors().end());
  for (const std::string& line : errors)
  {
    this->Status = STATUS_PARTIAL;
    this->Message += (this->Message.empty() ? "" : "\n") + line;
  }
}

//------------------------------------------------------------------------------
vtkSilhouettePass::vtkSilhouettePass() : Internals(new vtkInternals) {}

//------------------------------------------------------------------------------
vtkSilhouettePass::~vtkSilhouettePass() = default;

//------------------------------------------------------------------------------
void vtkSilhouettePass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "DelegatePass: " << this->Internals->Delegate.GetPointer() << "\n";
  os << indent << "LinesOnly: " << this->LinesOnly << "\n";
  os << indent << "LineWidth: " << this->LineWidth << "\n";
  os << indent << "Color: " << this->Color[0] << " " << this->Color[1] << " " << this->Color[2] << "\n";
  os << indent << "HiddenEdges: " << this->HiddenEdges << "\n";
  os << indent << "HiddenColor: " << this->HiddenColor[0] << " " << this->HiddenColor[1] << " "
     << this->HiddenColor[2] << "\n";
  os << indent << "HiddenOpacity: " << this->HiddenOpacity << "\n";
  os << indent << "SilhouetteEdges: " << this->SilhouetteEdges << "\n";
  os << indent << "BorderEdges: " << this->BorderEdges << "\n";
  os << indent << "CreaseEdges: " << this->CreaseEdges << "\n";
  os << indent << "FeatureAngle: " << this->FeatureAngle << "\n";
  os << indent << "Smooth: " << this->Smooth << "\n";
  os << indent << "Technique: " << this->Technique << "\n";
  os << indent << "DepthScale: " << this->DepthScale << "\n";
  os << indent << "WeldTolerance: " << this->WeldTolerance << "\n";
  os << indent << "MeasureStages: " << this->MeasureStages << "\n";
  os << indent << "Status: " << this->GetStatus() << "\n";
}

//------------------------------------------------------------------------------
void vtkSilhouettePass::SetDelegatePass(vtkRenderPass* delegatePass)
{
  if (delegatePass == this)
  {
    vtkErrorMacro("a pass cannot be its own delegate.");
    return;
  }
  if (this->Internals->Delegate != delegatePass)
  {
    this->Internals->Delegate = delegatePass;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkRenderPass* vtkSilhouettePass::GetDelegatePass()
{
  return this->Internals->Delegate;
}

//------------------------------------------------------------------------------
void vtkSilhouettePass::Render(const vtkRenderState* s)
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
  vtkInternals& internals = *this->Internals;
  if (renderer->GetPass() == this && !internals.InsideCameraPass)
  {
    // A complete pass: the camera pass sets viewport and background, then calls back.
    internals.InsideCameraPass = true;
    internals.Passes.camera->SetDelegatePass(this);
    internals.Passes.camera->Render(s);
    internals.Passes.camera->SetDelegatePass(nullptr);
    internals.InsideCameraPass = false;
    return;
  }
  if (vtkHardwareSelector* selector = renderer->GetSelector())
  {
    // Picking knows no passes: the selector draws all props itself, in its own colours.
    this->NumberOfRenderedProps = selector->Render(renderer, s->GetPropArray(), s->GetPropArrayCount());
    return;
  }
  const bool ownScene = !this->LinesOnly && internals.Delegate == nullptr;
  const bool complete = ownScene && !shadow::othersDrawTheRest(renderer, this);
  if (ownScene)
  {
    this->RenderScene(s, complete);
  }
  else if (!this->LinesOnly)
  {
    this->RenderPart(internals.Delegate, s);
  }
  internals.DrawLines(this, renderer, window);
  if (complete)
  {
    this->RenderPart(internals.Passes.overlay, s);
  }
  if (!internals.Message.empty() && internals.Message != internals.ReportedMessage)
  {
    vtkWarningMacro(<< internals.Message);
  }
  internals.ReportedMessage = internals.Message;
}

//------------------------------------------------------------------------------
void vtkSilhouettePass::RenderScene(const vtkRenderState* s, bool complete)
{
  shadow::ScenePasses& passes = this->Internals->Passes;
  if (!complete)
  {
    this->RenderPart(passes.opaque, s);
    return;
  }
  this->RenderPart(passes.lights, s);
  this->RenderPart(passes.opaque, s);
  this->RenderPart(passes.translucent, s);
  this->RenderPart(passes.volumetric, s);
}

//------------------------------------------------------------------------------
void vtkSilhouettePass::RenderPart(vtkRenderPass* pass, const vtkRenderState* s)
{
  pass->Render(s);
  this->NumberOfRenderedProps += pass->GetNumberOfRenderedProps();
}

//------------------------------------------------------------------------------
void vtkSilhouettePass::ReleaseGraphicsResources(vtkWindow* window)
{
  for (auto& entry : this->Internals->Renderers)
  {
    if (entry.second->Context.getWindow() == window)
    {
      entry.second->Release();
    }
  }
  this->Internals->Passes.ReleaseGraphicsResources(window);
  if (this->Internals->Delegate != nullptr)
  {
    this->Internals->Delegate->ReleaseGraphicsResources(window);
  }
  this->Superclass::ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
void vtkSilhouettePass::SetOutlined(vtkProp* prop, bool outlined)
{
  if (prop == nullptr)
  {
    vtkErrorMacro("SetOutlined needs a prop.");
    return;
  }
  if (outlined != this->GetOutlined(prop))
  {
    this->Internals->NotOutlined.set(prop, !outlined);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
bool vtkSilhouettePass::GetOutlined(vtkProp* prop)
{
  return !this->Internals->NotOutlined.has(prop);
}

//------------------------------------------------------------------------------
bool vtkSilhouettePass::GetLineMask(vtkImageData* image)
{
  auto* current = this->Internals->Current;
  if (image == nullptr || current == nullptr || current->Context.isLost() ||
      this->GetStatus() == STATUS_NOT_SUPPORTED)
  {
    vtkErrorMacro("GetLineMask needs an image and a rendering with lines before it.");
    return false;
  }
  current->Context.getWindow()->MakeCurrent();
  const std::vector<unsigned char> mask = current->Effect.readMask(current->Context.getWindow());
  const std::array<int, 2> size = current->Effect.getSize();
  image->SetDimensions(size[0], size[1], 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  std::copy(mask.begin(), mask.end(), static_cast<unsigned char*>(image->GetScalarPointer()));
  image->Modified();
  return true;
}

//------------------------------------------------------------------------------
int vtkSilhouettePass::GetStatus() const
{
  return this->Internals->Status;
}

std::string vtkSilhouettePass::GetStatusMessage() const
{
  return this->Internals->Message;
}

vtkIdType vtkSilhouettePass::GetDepthTriangles() const
{
  return static_cast<vtkIdType>(this->Internals->GetStatistics().depthTriangles);
}

vtkIdType vtkSilhouettePass::GetLineTriangles() const
{
  return static_cast<vtkIdType>(this->Internals->GetStatistics().lineTriangles);
}

vtkIdType vtkSilhouettePass::GetLineEdges() const
{
  return static_cast<vtkIdType>(this->Internals->GetStatistics().lineEdges);
}

int vtkSilhouettePass::GetNumberOfSkippedProps() const
{
  return static_cast<int>(this->Internals->Skipped.size());
}

std::string vtkSilhouettePass::GetSkippedProp(int index) const
{
  if (index < 0 || index >= this->GetNumberOfSkippedProps())
  {
    return "";
  }
  const auto skipped = std::next(this->Internals->Skipped.begin(), index);
  return skipped->name + ": " + skipped->reason;
}

double vtkSilhouettePass::GetSceneMilliseconds() const
{
  return this->Internals->SceneMilliseconds;
}

double vtkSilhouettePass::GetEdgeMilliseconds() const
{
  return this->Internals->GetStatistics().edgeMilliseconds;
}

double vtkSilhouettePass::GetDepthMilliseconds() const
{
  return this->Internals->GetStatistics().depthMilliseconds;
}

double vtkSilhouettePass::GetLineMilliseconds() const
{
  return this->Internals->GetStatistics().lineMilliseconds;
}

double vtkSilhouettePass::GetBlendMilliseconds() const
{
  return this->Internals->GetStatistics().blendMilliseconds;
}

vtkIdType vtkSilhouettePass::GetMemorySize() const
{
  std::size_t bytes = 0;
  for (const auto& entry : this->Internals->Renderers)
  {
    bytes += entry.second->Builder.getMemorySize() + entry.second->Effect.getGraphicsMemorySize();
  }
  return static_cast<vtkIdType>(bytes);
}
