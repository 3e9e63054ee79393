// Lights that are added one by one give the picture that is made with the mask, but for rounding.

#include <string>

#include <gtest/gtest.h>

#include <vtkImageActor.h>
#include <vtkImageData.h>
#include <vtkImageMapper3D.h>
#include <vtkProperty.h>

#include "BallScene.h"

using namespace shadow::test;

namespace
{

constexpr int lampCount = 3;

/// A ball scene under several coloured lights, so that one that is added once too often shows.
class AdditiveScene : public BallScene
{
public:
  AdditiveScene()
  {
    this->table->GetProperty()->SetColor(0.9, 0.6, 0.3);
    this->lamp->SetIntensity(0.3);
    this->addPointLight(-1.5, 4.0, 1.0)->SetColor(0.3, 0.1, 0.2);
    this->addDirectionalLight(0.3, -1.0, 0.5)->SetColor(0.1, 0.2, 0.3);
  }

  /// A second surface where the table is, of another colour.
  vtkActor* addSecondTable()
  {
    vtkActor* second = this->addMapper(this->table->GetMapper());
    second->GetProperty()->SetColor(0.2, 0.5, 0.9);
    second->GetProperty()->SetAmbient(0.2);
    return second;
  }
};

void expectPictureOfMask(AdditiveScene& scene, const std::string& what)
{
  scene.pass->SetCompositingToMask();
  const Pixels mask = scene.renderPicture();
  scene.pass->SetCompositingToAdditive();
  // Half a unit of rounding for the ambient part and for each light, and that of the mask's picture.
  EXPECT_EQ(countDifferent(scene.renderPicture(), mask, (lampCount + 2) / 2), 0u) << what;
  EXPECT_EQ(scene.pass->GetStatusMessage(), "") << what;
}

vtkSmartPointer<vtkImageData> makeCheckers()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(8, 8, 1);
  image->SetSpacing(0.15, 0.15, 1.0);
  image->SetOrigin(-1.5, 0.2, 0.4);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* values = static_cast<unsigned char*>(image->GetScalarPointer());
  for (int i = 0; i < 64; ++i)
  {
    values[3 * i] = (i + i / 8) % 2 == 0 ? 200 : 40;
    values[3 * i + 1] = 90;
    values[3 * i + 2] = static_cast<unsigned char>(3 * i);
  }
  return image;
}

} // namespace

TEST(PassAdditive, SurfacesThatCoincide_GetALightOnce)
{
  for (const int samples : {0, 4})
  {
    for (const bool wireframe : {false, true})
    {
      AdditiveScene scene;
      scene.window->SetMultiSamples(samples);
      vtkActor* second = scene.addSecondTable();
      scene.addSecondTable()->GetProperty()->SetColor(0.7, 0.1, 0.1);
      if (wireframe)
      {
        second->GetProperty()->SetRepresentationToWireframe();
      }
      expectPictureOfMask(scene, (wireframe ? "wireframe, samples " : "samples ") + std::to_string(samples));
    }
  }
}

TEST(PassAdditive, PropsThatHaveNoLights_AddNothing)
{
  AdditiveScene scene;
  const vtkSmartPointer<vtkImageData> image = makeCheckers();
  vtkNew<vtkImageActor> picture;
  picture->GetMapper()->SetInputData(image);
  scene.renderer->AddActor(picture);
  vtkActor* unlit = scene.addSecondTable();
  unlit->SetPosition(0.0, 0.2, 1.0);
  unlit->SetScale(0.2);
  unlit->GetProperty()->LightingOff();
  scene.pass->SetCompositingToMask();
  const Pixels mask = scene.renderPicture();
  scene.pass->SetCompositingToAdditive();
  EXPECT_EQ(countDifferent(scene.renderPicture(), mask, (lampCount + 2) / 2), 0u);
}

TEST(PassAdditive, PictureInPartOfWindow_OneBesideTheOtherUntouched)
{
  AdditiveScene scene;
  scene.renderer->SetViewport(0.5, 0.25, 1.0, 1.0);
  vtkNew<vtkRenderer> other;
  other->SetViewport(0.0, 0.0, 0.5, 1.0);
  other->SetBackground(0.2, 0.9, 0.4);
  scene.window->AddRenderer(other);
  expectPictureOfMask(scene, "two viewports");
}
