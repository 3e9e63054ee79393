// The three ways to attach the pass give one picture, and leave everything that has no shadow as VTK draws
// it.

#include <gtest/gtest.h>

#include <cstdlib>
#include <map>

#include <vtkActor2D.h>
#include <vtkColorTransferFunction.h>
#include <vtkHardwareSelector.h>
#include <vtkIdTypeArray.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkOpenGLGPUVolumeRayCastMapper.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty.h>
#include <vtkProperty2D.h>
#include <vtkRegularPolygonSource.h>
#include <vtkSelection.h>
#include <vtkSelectionNode.h>
#include <vtkSmartVolumeMapper.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

#include "BallScene.h"

using namespace shadow::test;

namespace
{

void addTranslucentBall(BallScene& scene, double z)
{
  vtkNew<vtkSphereSource> source;
  source->SetCenter(0.3, 0.6, z);
  vtkActor* actor = scene.addSource(source);
  actor->GetProperty()->SetOpacity(0.4);
  actor->GetProperty()->SetColor(0.9, 0.3, 0.1);
}

void addVolume(BallScene& scene, vtkVolumeMapper* mapper)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(8, 8, 8);
  image->SetSpacing(0.1, 0.1, 0.1);
  image->SetOrigin(-1.4, 0.3, 0.2);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  auto* values = static_cast<unsigned char*>(image->GetScalarPointer());
  for (int i = 0; i < 512; ++i)
  {
    values[i] = static_cast<unsigned char>(i / 2);
  }
  mapper->SetInputDataObject(image);
  vtkNew<vtkColorTransferFunction> colour;
  colour->AddRGBPoint(0.0, 0.1, 0.9, 0.2);
  colour->AddRGBPoint(255.0, 0.9, 0.9, 0.1);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, 0.1);
  opacity->AddPoint(255.0, 0.6);
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  volume->GetProperty()->SetColor(colour);
  volume->GetProperty()->SetScalarOpacity(opacity);
  scene.renderer->AddVolume(volume);
}

void addOverlay(BallScene& scene)
{
  vtkNew<vtkRegularPolygonSource> source;
  source->SetRadius(20.0);
  source->SetCenter(30.0, 30.0, 0.0);
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  vtkNew<vtkActor2D> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.2, 0.4, 1.0);
  scene.renderer->AddViewProp(actor);
  vtkNew<vtkTextActor> text;
  text->SetInput("shadow");
  text->SetPosition(110.0, 10.0);
  text->GetTextProperty()->SetFontSize(18);
  scene.renderer->AddViewProp(text);
}

/// The picture of VTK's passes without shadows.
Pixels plainPicture(BallScene& scene)
{
  attachPlainSteps(scene.renderer);
  return scene.renderPicture();
}

/// What the pass makes of a scene whose shadows take nothing away has to be what VTK makes of it: without a
/// pass, or with a vtkRenderStepsPass, which blends translucent actors in the order in which they come.
void expectDrawnAsWithoutShadows(BallScene& scene)
{
  scene.pass->SetShadowIntensity(0.0);
  const Pixels bySteps = plainPicture(scene);
  scene.renderer->SetPass(nullptr);
  const Pixels byRenderer = scene.renderPicture();
  for (const Use use : allUses)
  {
    attach(scene.renderer, scene.pass, use);
    const Pixels& plain = use == Use::OpaqueOfSteps ? bySteps : byRenderer;
    EXPECT_EQ(countDifferent(scene.renderPicture(), plain), 0u) << toString(use);
  }
}

std::multimap<vtkProp*, vtkIdType> pick(BallScene& scene)
{
  scene.window->Render();
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(scene.renderer);
  selector->SetArea(0, 0, 199, 149);
  selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_CELLS);
  const auto selection = vtkSmartPointer<vtkSelection>::Take(selector->Select());
  std::multimap<vtkProp*, vtkIdType> hits;
  for (unsigned int i = 0; selection != nullptr && i < selection->GetNumberOfNodes(); ++i)
  {
    vtkSelectionNode* node = selection->GetNode(i);
    auto* prop = vtkProp::SafeDownCast(node->GetProperties()->Get(vtkSelectionNode::PROP()));
    auto* cells = vtkIdTypeArray::SafeDownCast(node->GetSelectionList());
    for (vtkIdType j = 0; j < cells->GetNumberOfTuples(); ++j)
    {
      hits.emplace(prop, cells->GetValue(j));
    }
  }
  return hits;
}

} // namespace

TEST(PassUse, BallOverTable_ThreeUses_SamePictureAndMask)
{
  BallScene scene;
  const Pixels plain = plainPicture(scene);
  attach(scene.renderer, scene.pass, Use::Complete);
  const Pixels picture = scene.renderPicture();
  const Pixels mask = scene.renderMask();
  EXPECT_GT(countValue(mask, 0), 400u);
  EXPECT_GT(countDifferent(picture, plain, 20), 400u) << "no shadow in the picture";
  for (const Use use : allUses)
  {
    attach(scene.renderer, scene.pass, use);
    EXPECT_EQ(countDifferent(scene.renderPicture(), picture), 0u) << toString(use);
    EXPECT_EQ(scene.renderMask(), mask) << toString(use);
    EXPECT_EQ(scene.pass->GetStatus(), vtkShadowVolumePass::STATUS_OK) << toString(use);
  }
}

TEST(PassUse, VolumeAndOverlay_ThreeUses_SamePicture)
{
  BallScene scene;
  vtkNew<vtkSmartVolumeMapper> mapper;
  addVolume(scene, mapper);
  addOverlay(scene);
  const Pixels picture = scene.renderPicture();
  for (const Use use : allUses)
  {
    attach(scene.renderer, scene.pass, use);
    EXPECT_EQ(countDifferent(scene.renderPicture(), picture, 1), 0u) << toString(use);
  }
}

TEST(PassUse, TranslucentActors_DrawnAsWithoutShadows)
{
  BallScene scene;
  addTranslucentBall(scene, 1.2);
  addTranslucentBall(scene, 0.6);
  const Pixels with = plainPicture(scene);
  expectDrawnAsWithoutShadows(scene);
  scene.renderer->RemoveAllViewProps();
  EXPECT_GT(countDifferent(scene.renderPicture(), with), 1000u);
}

TEST(PassUse, Volume_DrawnAsWithoutShadows)
{
  BallScene scene;
  const Pixels without = plainPicture(scene);
  vtkNew<vtkSmartVolumeMapper> mapper;
  addVolume(scene, mapper);
  ASSERT_GT(countDifferent(plainPicture(scene), without, 20), 1000u) << "the volume cannot be seen";
  expectDrawnAsWithoutShadows(scene);
}

TEST(PassUse, VolumeOfGPURayCastMapper_DrawnAsWithoutShadows)
{
  BallScene scene;
  vtkNew<vtkOpenGLGPUVolumeRayCastMapper> mapper;
  addVolume(scene, mapper);
  expectDrawnAsWithoutShadows(scene);
}

TEST(PassUse, OverlayProps_DrawnAsWithoutShadows)
{
  BallScene scene;
  const Pixels without = plainPicture(scene);
  addOverlay(scene);
  ASSERT_GT(countDifferent(plainPicture(scene), without, 20), 1000u) << "the overlay cannot be seen";
  expectDrawnAsWithoutShadows(scene);
}

// Red is the left eye's picture, green and blue are the right one's.
TEST(PassUse, Stereo_EachEyeHasItsOwnShadow)
{
  BallScene scene;
  scene.window->StereoRenderOn();
  const auto pictureOf = [&scene](int type)
  {
    scene.window->SetStereoType(type);
    return scene.renderPicture();
  };
  const Pixels left = pictureOf(VTK_STEREO_LEFT);
  const Pixels right = pictureOf(VTK_STEREO_RIGHT);
  const Pixels both = pictureOf(VTK_STEREO_RED_BLUE);
  ASSERT_GT(countDifferent(left, right, 20), 500u);
  // VTK makes each eye's picture grey, by weights of its own.
  const auto grey = [](const Pixels& picture, std::size_t pixel)
  { return (picture[pixel] + picture[pixel + 1] + picture[pixel + 2]) / 3; };
  int wrong = 0;
  for (std::size_t pixel = 0; pixel < both.size(); pixel += 3)
  {
    wrong += std::abs(both[pixel] - grey(left, pixel)) > 3 ? 1 : 0;
    wrong += std::abs(both[pixel + 2] - grey(right, pixel)) > 3 ? 1 : 0;
  }
  EXPECT_EQ(wrong, 0);
}

TEST(PassUse, HardwareSelector_SameHitsWithAndWithoutPass)
{
  BallScene scene;
  addTranslucentBall(scene, 1.2);
  scene.renderer->SetPass(nullptr);
  const auto expected = pick(scene);
  ASSERT_GT(expected.size(), 20u);
  ASSERT_GT(expected.count(scene.ballActor), 5u);
  ASSERT_EQ(expected.count(scene.table), 1u);
  for (const Use use : allUses)
  {
    attach(scene.renderer, scene.pass, use);
    const Pixels before = scene.renderPicture();
    EXPECT_EQ(pick(scene), expected) << toString(use);
    EXPECT_EQ(countDifferent(scene.renderPicture(), before), 0u)
        << "picking changed the picture: " << toString(use);
  }
}

TEST(PassUse, ScopeIsSetByHand_BesideNothing_OpaqueOnlyDrawsNoOverlay)
{
  BallScene scene;
  addOverlay(scene);
  const Pixels complete = scene.renderPicture();
  scene.pass->SetScope(vtkShadowVolumePass::SCOPE_OPAQUE);
  scene.pass->Modified();
  EXPECT_GT(countDifferent(scene.renderPicture(), complete, 20), 1000u);
  scene.pass->SetScope(vtkShadowVolumePass::SCOPE_COMPLETE);
  EXPECT_EQ(countDifferent(scene.renderPicture(), complete), 0u);
}
