#include "SilhouettePassInternals.h"

#include <algorithm>
#include <cmath>

#include <vtkMapper.h>
#include <vtkProp.h>
#include <vtkRenderState.h>

#include "Stopwatch.h"

namespace
{

bool hasMoreToBlend(const vtkRenderState* s)
{
  vtkProp** props = s->GetPropArray();
  return std::any_of(props, props + s->GetPropArrayCount(),
                     [](vtkProp* prop)
                     {
                       return prop->GetVisibility() != 0 &&
                              (prop->HasTranslucentPolygonalGeometry() != 0 || prop->IsA("vtkVolume") != 0);
                     });
}

/// VTK pulls lines and points that lie on a surface nearer, by parameters of all mappers: these must not hide the
/// surface's own lines.
void allowForCoincidentLines(double widestLine, shadow::OutlineEffect::Settings& settings)
{
  if (widestLine == 0.0)
  {
    return;
  }
  double lines[2] = {0.0, 0.0};
  double points[2] = {0.0, 0.0};
  vtkMapper::GetResolveCoincidentTopologyLineOffsetParameters(lines[0], lines[1]);
  vtkMapper::GetResolveCoincidentTopologyPointOffsetParameter(points[1]);
  constexpr double unit = 1.0 / 65000.0; // as VTK's shaders have it
  settings.windowTolerance += 1.05 * unit * std::max(std::abs(lines[1]), std::abs(points[1]));
  settings.windowReach += 1.0 + 0.5 * widestLine + std::abs(lines[0]);
}

} // namespace

//------------------------------------------------------------------------------
vtkSilhouettePass::vtkInternals::RendererState&
vtkSilhouettePass::vtkInternals::GetState(vtkOpenGLRenderer* renderer, vtkOpenGLRenderWindow* window)
{
  this->Current = nullptr;
  RendererState& state = this->Renderers.get(renderer, window);
  state.Context.acquire([&state] { state.Effect.release(true); });
  this->Current = &state;
  return state;
}

//------------------------------------------------------------------------------
void vtkSilhouettePass::vtkInternals::DrawLines(vtkSilhouettePass* self, const vtkRenderState* s,
                                                vtkOpenGLRenderer* renderer, vtkOpenGLRenderWindow* window,
                                                bool keepsDepth)
{
  RendererState& state = this->GetState(renderer, window);
  this->Status = STATUS_OK;
  this->Message.clear();
  const shadow::View view = shadow::currentView(renderer, window);
  if (const std::string fault = shadow::findFault(view); !fault.empty())
  {
    this->Status = STATUS_NOT_SUPPORTED;
    this->Message = fault;
    return;
  }

  const shadow::Stopwatch stage;
  shadow::SceneBuilder::Settings sceneSettings;
  sceneSettings.weldTolerance = self->WeldTolerance;
  sceneSettings.weldsRounding = true; // a seam that nobody sees must not show as a border
  sceneSettings.copiesCountOnce = true; // nor the back of a sheet, stored beside its front
  sceneSettings.drawn = shadow::drawnProps(s);
  sceneSettings.isCasting = [this](vtkProp* prop) { return !this->NotOutlined.has(prop); };
  sceneSettings.product = "outline";
  state.Builder.update(renderer, sceneSettings, state.Effect);
  this->Skipped = state.Builder.getSkipped();
  this->SceneMilliseconds = stage.getMilliseconds();

  shadow::OutlineEffect::Settings settings;
  settings.technique = static_cast<shadow::LineTechnique>(self->Technique);
  settings.leavesOutFlatFaces = self->LeaveOutFlatFaces;
  settings.splitsLargeFaces = self->SplitLargeFaces;
  settings.depthScale = self->DepthScale;
  settings.lineWidth = self->LineWidth * state.Scale.update(renderer, window);
  settings.silhouette = self->SilhouetteEdges;
  settings.border = self->BorderEdges;
  settings.crease = self->CreaseEdges;
  settings.featureAngle = self->FeatureAngle;
  settings.behindWindow = state.Builder.isMoreDrawn() || renderer->GetPreserveDepthBuffer() != 0;
  allowForCoincidentLines(state.Builder.getWidestLine(), settings);
  settings.keepsDepth = keepsDepth && hasMoreToBlend(s);
  settings.waitAfterStages = self->MeasureStages;
  shadow::OutlineEffect::Look look;
  look.color = {self->Color[0], self->Color[1], self->Color[2]};
  look.hiddenColor = {self->HiddenColor[0], self->HiddenColor[1], self->HiddenColor[2],
                      self->HiddenEdges ? self->HiddenOpacity : 0.0};
  look.smooth = self->Smooth;
  std::set<std::string> errors(state.Builder.getErrors().begin(), state.Builder.getErrors().end());
  std::string error;
  if (!state.Effect.renderLines(window, view, settings, error) ||
      !state.Effect.blend(window, look, self->MeasureStages, error))
  {
    this->Status = STATUS_NOT_SUPPORTED;
    this->Message = error;
  }
  errors.insert(state.Effect.getErrors().begin(), state.Effect.getErrors().end());
  if (this->Status == STATUS_OK && !errors.empty())
  {
    this->Status = STATUS_PARTIAL;
  }
  for (const std::string& line : errors)
  {
    this->Message += (this->Message.empty() ? "" : "\n") + line;
  }
}
