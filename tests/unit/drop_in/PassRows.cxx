#include <vtkCameraPass.h>
#include <vtkEDLShading.h>
#include <vtkGaussianBlurPass.h>
#include <vtkLightsPass.h>
#include <vtkOpaquePass.h>
#include <vtkOpenGLFXAAPass.h>
#include <vtkOverlayPass.h>
#include <vtkRenderPassCollection.h>
#include <vtkRenderStepsPass.h>
#include <vtkSSAAPass.h>
#include <vtkSSAOPass.h>
#include <vtkSequencePass.h>
#include <vtkSilhouettePass.h>
#include <vtkSobelGradientMagnitudePass.h>
#include <vtkTranslucentPass.h>
#include <vtkVolumetricPass.h>

#include "../../../plugin/vtkShadowCompat.h"
#include "DropInCase.h"

#if VTKSHADOW_VTK_IS_WHOLE
#include <vtkOutlineGlowPass.h>
#include <vtkPanoramicProjectionPass.h>
#include <vtkSimpleMotionBlurPass.h>
#include <vtkToneMappingPass.h>
#endif

// Passes of VTK's above ours and beside it.
namespace shadow::test
{

namespace
{

void build(DropInScene& scene)
{
  addBox(scene, 1.0, 0.6);
}

vtkSmartPointer<vtkSequencePass> sequence(std::initializer_list<vtkSmartPointer<vtkRenderPass>> passes)
{
  vtkNew<vtkRenderPassCollection> collection;
  for (const auto& pass : passes)
  {
    collection->AddItem(pass);
  }
  const auto made = vtkSmartPointer<vtkSequencePass>::New();
  made->SetPasses(collection);
  return made;
}

/// All that a scene is made of, drawn by VTK's passes.
vtkSmartPointer<vtkRenderPass> makeParts()
{
  return sequence({vtkNew<vtkLightsPass>(), vtkNew<vtkOpaquePass>(), vtkNew<vtkTranslucentPass>(),
                   vtkNew<vtkVolumetricPass>(), vtkNew<vtkOverlayPass>()});
}

vtkSmartPointer<vtkRenderPass> belowCamera(vtkRenderPass* pass)
{
  const auto camera = vtkSmartPointer<vtkCameraPass>::New();
  camera->SetDelegatePass(pass);
  return camera;
}

void setAbove(vtkSSAOPass* pass)
{
  pass->SetRadius(0.5);
  pass->SetBias(0.01);
}
#if VTKSHADOW_VTK_IS_WHOLE
void setAbove(vtkSimpleMotionBlurPass* pass)
{
  pass->SetSubFrames(2);
}
#endif
void setAbove(vtkRenderPass*) {}

/// Two rows: a pass directly above ours, and with a camera pass between.
template <class Above>
void addAbove(std::vector<Row>& rows, const std::string& name, void (*fill)(DropInScene&) = build,
              unsigned ways = filteredWays)
{
  for (const bool camera : {false, true})
  {
    const Attach attach = [camera](vtkRenderer* renderer, vtkRenderPass* ours)
    {
      vtkNew<Above> above;
      setAbove(above.GetPointer());
      above->SetDelegatePass(ours == nullptr ? belowCamera(makeParts())
                             : camera        ? belowCamera(ours)
                                             : vtkSmartPointer<vtkRenderPass>(ours));
      renderer->SetPass(above);
    };
    rows.push_back({name + (camera ? "_above_a_camera" : "_above"), fill, attach, ways});
  }
}

void attachToSteps(vtkRenderer* renderer, vtkRenderPass* ours)
{
  vtkNew<vtkRenderStepsPass> steps;
  if (ours != nullptr)
  {
    steps->SetOpaquePass(ours);
  }
  renderer->SetPass(steps);
}

void attachBelowCamera(vtkRenderer* renderer, vtkRenderPass* ours)
{
  renderer->SetPass(vtkOpenGLRenderPass::SafeDownCast(ours));
  if (ours != nullptr)
  {
    renderer->SetPass(vtkCameraPass::SafeDownCast(belowCamera(ours)));
  }
}

void attachAlone(vtkRenderer* renderer, vtkRenderPass* ours)
{
  renderer->SetPass(ours == nullptr ? nullptr : sequence({ours}));
}

void attachBeforeLines(vtkRenderer* renderer, vtkRenderPass* ours)
{
  vtkNew<vtkSilhouettePass> lines;
  lines->LinesOnlyOn();
  lines->SilhouetteEdgesOff();
  lines->BorderEdgesOff();
  renderer->SetPass(ours == nullptr ? nullptr : sequence({ours, lines}));
}

void attachBelowSupersamplingAndLines(vtkRenderer* renderer, vtkRenderPass* ours)
{
  vtkNew<vtkSSAAPass> supersampling;
  supersampling->SetDelegatePass(ours != nullptr ? ours : belowCamera(makeParts()).GetPointer());
  vtkNew<vtkSilhouettePass> lines;
  lines->SetDelegatePass(supersampling);
  lines->SilhouetteEdgesOff();
  lines->BorderEdgesOff();
  // The lines' pass erases the window, also its depth, below which there is nothing else.
  const vtkSmartPointer<vtkRenderPass> plain = belowCamera(supersampling);
  renderer->SetPass(ours != nullptr ? vtkRenderPass::SafeDownCast(lines) : plain.GetPointer());
}

void attachInSequence(vtkRenderer* renderer, vtkRenderPass* ours)
{
  const vtkSmartPointer<vtkRenderPass> opaque = ours != nullptr ? ours : vtkNew<vtkOpaquePass>().GetPointer();
  renderer->SetPass(vtkCameraPass::SafeDownCast(belowCamera(
      sequence({vtkNew<vtkLightsPass>(), opaque, vtkNew<vtkTranslucentPass>(), vtkNew<vtkOverlayPass>()}))));
}

void buildWithGlass(DropInScene& scene)
{
  build(scene);
  addGlass(scene, {1, 0, 0}, {-0.5, 0.6, 1.0});
  addGlass(scene, {0, 0, 1}, {0.1, 0.6, 1.2});
}

#if VTKSHADOW_VTK_IS_WHOLE
void attachToStepsBelow(vtkRenderer* renderer, vtkRenderPass* ours)
{
  vtkNew<vtkRenderStepsPass> steps;
  if (ours != nullptr)
  {
    steps->SetOpaquePass(ours);
  }
  vtkNew<vtkToneMappingPass> above;
  above->SetDelegatePass(steps);
  renderer->SetPass(above);
}

/// What glows has black around it.
void buildGlowing(DropInScene& scene)
{
  build(scene);
  scene.table->VisibilityOff();
  scene.renderer->SetBackground(0.0, 0.0, 0.0);
}
#endif

} // namespace

std::vector<Row> treeRows()
{
  return {
      {"opaque_pass_of_steps", build, attachToSteps},
      {"opaque_pass_of_steps_and_glass", buildWithGlass, attachToSteps},
      {"below_a_camera", build, attachBelowCamera},
      {"below_a_camera_and_glass", buildWithGlass, attachBelowCamera},
      {"alone_in_a_sequence", build, attachAlone},
      {"before_lines_in_a_sequence", build, attachBeforeLines},
      {"opaque_pass_in_a_sequence", buildWithGlass, attachInSequence},
  };
}

std::vector<Row> filterRows()
{
  std::vector<Row> rows;
  addAbove<vtkSSAAPass>(rows, "ssaa");
  rows.push_back({"ssaa_below_lines", build, attachBelowSupersamplingAndLines, filteredWays});
  addAbove<vtkEDLShading>(rows, "edl");
  addAbove<vtkGaussianBlurPass>(rows, "gaussian_blur");
  addAbove<vtkSobelGradientMagnitudePass>(rows, "sobel");
  // vtkDepthOfFieldPass is left out: it does not draw the same picture twice.
  addAbove<vtkOpenGLFXAAPass>(rows, "fxaa_pass");
  addAbove<vtkSSAOPass>(rows, "ssao_pass", build, everyWay & ~Shadowed);
#if VTKSHADOW_VTK_IS_WHOLE
  rows.push_back({"steps_below_tone_mapping", build, attachToStepsBelow});
  addAbove<vtkToneMappingPass>(rows, "tone_mapping");
  addAbove<vtkOutlineGlowPass>(rows, "outline_glow", buildGlowing);
  addAbove<vtkSimpleMotionBlurPass>(rows, "motion_blur");
  addAbove<vtkPanoramicProjectionPass>(rows, "panorama");
#endif
  return rows;
}

} // namespace shadow::test
