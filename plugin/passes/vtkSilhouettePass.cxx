#include "vtkSilhouettePass.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <vtkImageData.h>
#include <vtkObjectFactory.h>
#include <vtkProp.h>
#include <vtkRenderState.h>

#include "PassScope.h"
#include "ShadowPassInternals.h"
#include "SilhouettePassInternals.h"

vtkStandardNewMacro(vtkSilhouettePass);

namespace
{

/// Sets a flag until the end of the block.
class ScopedFlag
{
public:
  explicit ScopedFlag(bool& theFlag) : flag(theFlag) { this->flag = true; }
  ~ScopedFlag() { this->flag = false; }
  ScopedFlag(const ScopedFlag&) = delete;
  ScopedFlag& operator=(const ScopedFlag&) = delete;

private:
  bool& flag;
};

} // namespace

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
  os << indent << "LeaveOutFlatFaces: " << this->LeaveOutFlatFaces << "\n";
  os << indent << "SplitLargeFaces: " << this->SplitLargeFaces << "\n";
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
void vtkSilhouettePass::SetLineWidth(double width)
{
  if (!std::isfinite(width) || width <= 0.0)
  {
    vtkWarningMacro("a line width of " << width << " pixels cannot be drawn; it stays " << this->LineWidth
                                       << ".");
    return;
  }
  const double clamped = std::clamp(width, this->GetLineWidthMinValue(), this->GetLineWidthMaxValue());
  if (clamped != this->LineWidth)
  {
    this->LineWidth = clamped;
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
  if (shadow::hasNoPixels(renderer))
  {
    this->Internals->Status = STATUS_OK;
    this->Internals->Message.clear();
    return;
  }
  vtkInternals& internals = *this->Internals;
  if (internals.Passes.renderInstead(this, !this->LinesOnly, renderer, s, this->NumberOfRenderedProps))
  {
    return;
  }
  if (internals.Busy)
  {
    internals.LedBack = true;
    return;
  }
  internals.LedBack = false;
  const ScopedFlag busy(internals.Busy);
  const bool ownScene = !this->LinesOnly && internals.Delegate == nullptr;
  if (ownScene)
  {
    this->RenderScene(s, renderer, window);
  }
  else
  {
    this->RenderDelegate(s, renderer, window);
  }
  if (internals.LedBack)
  {
    internals.Status = STATUS_NOT_SUPPORTED;
    internals.Message = "the delegates of this pass lead back to it; one that does draws nothing";
  }
  if (internals.Current->Messages.isNews(internals.Message))
  {
    vtkWarningMacro(<< internals.Message);
  }
}

//------------------------------------------------------------------------------
void vtkSilhouettePass::RenderScene(const vtkRenderState* s, vtkOpenGLRenderer* renderer,
                                    vtkOpenGLRenderWindow* window)
{
  shadow::ScenePasses& passes = this->Internals->Passes;
  const bool complete = !shadow::othersDrawTheRest(renderer, this);
  if (complete)
  {
    this->NumberOfRenderedProps += passes.drawLights(s);
  }
  this->RenderPart(passes.chooseOpaque(s, complete), s);
  this->Internals->DrawLines(this, s, renderer, window, true);
  if (complete)
  {
    this->NumberOfRenderedProps += passes.drawRest(s);
  }
}

//------------------------------------------------------------------------------
void vtkSilhouettePass::RenderDelegate(const vtkRenderState* s, vtkOpenGLRenderer* renderer,
                                       vtkOpenGLRenderWindow* window)
{
  vtkRenderPass* delegate = this->LinesOnly ? nullptr : this->Internals->Delegate;
  bool drawn = false;
  if (auto* shadows = vtkShadowVolumePass::SafeDownCast(delegate))
  {
    shadows->Internals->AfterOpaque = [&]
    {
      this->Internals->DrawLines(this, s, renderer, window, true);
      drawn = true;
    };
    this->RenderPart(shadows, s);
    shadows->Internals->AfterOpaque = nullptr;
  }
  else if (delegate != nullptr)
  {
    this->RenderPart(delegate, s);
  }
  if (!drawn)
  {
    this->Internals->DrawLines(this, s, renderer, window, shadow::othersDrawTheRest(renderer, this));
  }
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
  if (this->Internals->Busy)
  {
    return;
  }
  const ScopedFlag busy(this->Internals->Busy);
  this->Internals->Renderers.release(window);
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
  const shadow::ContextScope scope(current->Context.getWindow());
  const std::vector<unsigned char> mask = current->Effect.readMask(current->Context.getWindow());
  const std::array<int, 2> size = current->Effect.getSize();
  image->SetDimensions(size[0], size[1], 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  std::copy(mask.begin(), mask.end(), static_cast<unsigned char*>(image->GetScalarPointer()));
  image->Modified();
  return true;
}
