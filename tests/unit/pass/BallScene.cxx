#include "BallScene.h"

#include <algorithm>
#include <cmath>

#include <vtkCamera.h>
#include <vtkCameraPass.h>
#include <vtkImageData.h>
#include <vtkPlaneSource.h>
#include <vtkProperty.h>
#include <vtkRenderStepsPass.h>
#include <vtkTexture.h>

#include <gtest/gtest.h>

#include "Capabilities.h"

namespace shadow::test
{

const char* toString(Use use)
{
  switch (use)
  {
  case Use::Complete:
    return "complete pass";
  case Use::Delegate:
    return "delegate of a camera pass";
  default:
    return "opaque pass of a vtkRenderStepsPass";
  }
}

void attach(vtkRenderer* renderer, vtkRenderPass* pass, Use use)
{
  if (use == Use::Delegate)
  {
    vtkNew<vtkCameraPass> cameraPass;
    cameraPass->SetDelegatePass(pass);
    renderer->SetPass(cameraPass);
  }
  else if (use == Use::OpaqueOfSteps)
  {
    vtkNew<vtkRenderStepsPass> steps;
    steps->SetOpaquePass(pass);
    renderer->SetPass(steps);
  }
  else
  {
    renderer->SetPass(vtkOpenGLRenderPass::SafeDownCast(pass));
  }
}

void attachPlainSteps(vtkRenderer* renderer)
{
  vtkNew<vtkRenderStepsPass> steps;
  renderer->SetPass(steps);
}

BallScene::BallScene(int width, int height) : ShadowScene(width, height)
{
  this->ball->SetCenter(0.0, 1.0, 0.0);
  this->ball->SetRadius(0.5);
  this->ball->SetThetaResolution(16);
  this->ball->SetPhiResolution(12);
  this->ballActor = this->addSource(this->ball);
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-2.0, 0.0, 2.0);
  plane->SetPoint1(2.0, 0.0, 2.0);
  plane->SetPoint2(-2.0, 0.0, -2.0);
  this->table = this->addSource(plane);
  this->lamp = this->addPointLight(-1.5, 4.0, 0.0);
  vtkCamera* camera = this->renderer->GetActiveCamera();
  camera->SetPosition(0.0, 3.0, 6.0);
  camera->SetFocalPoint(0.0, 0.4, 0.0);
  camera->SetViewUp(0.0, 1.0, 0.0);
  this->renderer->ResetCameraClippingRange();
}

std::array<int, 2> BallScene::toPixel(const glm::dvec3& pointWC)
{
  this->renderer->SetWorldPoint(pointWC.x, pointWC.y, pointWC.z, 1.0);
  this->renderer->WorldToDisplay();
  const double* display = this->renderer->GetDisplayPoint();
  return {static_cast<int>(std::floor(display[0])), static_cast<int>(std::floor(display[1]))};
}

void BallScene::expectHiddenBacks(int onSoftware)
{
  this->window->MakeCurrent();
  EXPECT_EQ(this->pass->GetNumberOfHiddenBacks(), queryCapabilities().software ? onSoftware : 0);
}

int BallScene::maskAt(const glm::dvec3& pointWC, int light)
{
  const Pixels mask = this->renderMask(light);
  const std::array<int, 2> pixel = this->toPixel(pointWC);
  const int* origin = this->renderer->GetOrigin();
  const int* size = this->renderer->GetSize();
  return mask.at(static_cast<std::size_t>((pixel[1] - origin[1]) * size[0] + pixel[0] - origin[0]));
}

std::array<int, 3> BallScene::colourAt(const glm::dvec3& pointWC)
{
  const Pixels picture = this->renderPicture();
  const std::array<int, 2> pixel = this->toPixel(pointWC);
  const auto first = static_cast<std::size_t>(3 * (pixel[1] * this->window->GetSize()[0] + pixel[0]));
  return {picture.at(first), picture.at(first + 1), picture.at(first + 2)};
}

double BallScene::greyAt(const glm::dvec3& pointWC)
{
  const std::array<int, 3> colour = this->colourAt(pointWC);
  return (colour[0] + colour[1] + colour[2]) / 3.0;
}

vtkSmartPointer<vtkTexture> makeTextureOfHoles()
{
  constexpr int size = 16;
  vtkNew<vtkImageData> image;
  image->SetDimensions(size, size, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  auto* texels = static_cast<unsigned char*>(image->GetScalarPointer());
  std::fill_n(texels, 4 * size * size, static_cast<unsigned char>(0));
  std::fill_n(texels, 4, static_cast<unsigned char>(255));
  const auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputData(image);
  return texture;
}

std::size_t countValue(const Pixels& pixels, int value)
{
  return static_cast<std::size_t>(
      std::count(pixels.begin(), pixels.end(), static_cast<unsigned char>(value)));
}

vtkSmartPointer<MessageCounter> MessageCounter::observe(vtkObject* object)
{
  auto counter = vtkSmartPointer<MessageCounter>::Take(new MessageCounter);
  object->AddObserver(vtkCommand::ErrorEvent, counter);
  object->AddObserver(vtkCommand::WarningEvent, counter);
  return counter;
}

void MessageCounter::Execute(vtkObject*, unsigned long event, void* data)
{
  (event == vtkCommand::ErrorEvent ? this->errors : this->warnings) += 1;
  this->last = data != nullptr ? static_cast<const char*>(data) : "";
}

} // namespace shadow::test
