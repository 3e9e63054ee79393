#include "SharedWindows.h"

#include <map>

#include <vtkCamera.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkOpenGLRenderPass.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderStepsPass.h>
#include <vtkShadowVolumePass.h>
#include <vtkSilhouettePass.h>
#include <vtkSphereSource.h>
#include <vtkUnsignedCharArray.h>

#include "WindowUnderTest.h"

namespace shadow::test
{

namespace
{

constexpr int shapeCount = 35;

/// The same for shapes that differ by shapeCount.
vtkSmartPointer<vtkMapper> makeMapper(int shape)
{
  vtkNew<vtkSphereSource> source;
  source->SetThetaResolution(5 + shape % 7);
  source->SetPhiResolution(6 + shape % 5);
  const auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
  mapper->SetInputConnection(source->GetOutputPort());
  return mapper;
}

std::vector<unsigned char> readPicture(vtkRenderWindow* window)
{
  window->Render();
  const int* size = window->GetSize();
  vtkNew<vtkUnsignedCharArray> pixels;
  window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, 0, pixels, 0);
  return {pixels->GetPointer(0), pixels->GetPointer(0) + pixels->GetNumberOfValues()};
}

} // namespace

SharedWindows::SharedWindows(Drawing drawing)
{
  for (std::size_t place = 0; place < actorCount; ++place)
  {
    this->props[place] = {makeActor(place, this->shapes), this->shapes};
    ++this->shapes;
  }
  const vtkSmartPointer<vtkRenderPass> pass = makePass(drawing);
  for (std::size_t one = 0; one < windowCount; ++one)
  {
    Stage& stage = this->stages[one];
    const int step = 10 * static_cast<int>(one);
    stage.drawing = drawing;
    stage.size = {100 + step, 80 - step};
    stage.shown.fill(true);
    openWindow(stage);
    makeRenderer(stage, pass);
    this->showActors(stage);
  }
}

std::size_t SharedWindows::countWrong(std::size_t one)
{
  const std::vector<unsigned char> picture = readPicture(this->stages[one].window);
  const std::vector<unsigned char>& truth = this->drawAlone(this->stages[one]);
  if (picture.size() != truth.size())
  {
    return truth.size();
  }
  std::size_t wrong = 0;
  for (std::size_t value = 0; value < truth.size(); ++value)
  {
    wrong += picture[value] != truth[value] ? 1 : 0;
  }
  return wrong;
}

const std::vector<unsigned char>& SharedWindows::drawAlone(const Stage& stage) const
{
  static std::map<std::vector<int>, std::vector<unsigned char>> pictures;
  std::vector<int> key = {static_cast<int>(stage.drawing), stage.size[0], stage.size[1]};
  for (std::size_t place = 0; place < actorCount; ++place)
  {
    key.push_back(stage.shown[place] ? this->props[place].shape % shapeCount : -1);
  }
  std::vector<unsigned char>& picture = pictures[key];
  if (picture.empty())
  {
    Stage alone = stage;
    openWindow(alone);
    alone.renderer = nullptr;
    makeRenderer(alone, makePass(stage.drawing));
    for (std::size_t place = 0; place < actorCount; ++place)
    {
      if (stage.shown[place])
      {
        alone.renderer->AddActor(makeActor(place, this->props[place].shape));
      }
    }
    picture = readPicture(alone.window);
  }
  return picture;
}

void SharedWindows::openWindow(Stage& stage)
{
  stage.window = vtkOpenGLRenderWindow::SafeDownCast(makeWindow());
  stage.window->SetMultiSamples(0);
  stage.window->SetSize(stage.size[0], stage.size[1]);
}

/// Puts a renderer without actors into the stage's window, in place of the one that is there.
void SharedWindows::makeRenderer(Stage& stage, vtkRenderPass* pass)
{
  if (stage.renderer != nullptr)
  {
    stage.window->RemoveRenderer(stage.renderer);
  }
  stage.renderer = vtkSmartPointer<vtkRenderer>::New();
  stage.renderer->SetBackground(0.2, 0.25, 0.3);
  stage.renderer->AutomaticLightCreationOff();
  vtkNew<vtkLight> lamp;
  lamp->SetPositional(true);
  lamp->SetConeAngle(180.0);
  lamp->SetPosition(-4.0, 3.0, 1.5);
  stage.renderer->AddLight(lamp);
  vtkCamera* camera = stage.renderer->GetActiveCamera();
  camera->SetPosition(0.5, 2.0, 5.0);
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetClippingRange(1.0, 20.0); // not one that depends on what was drawn before
  stage.renderer->SetPass(vtkOpenGLRenderPass::SafeDownCast(pass));
  stage.window->AddRenderer(stage.renderer);
}

void SharedWindows::showActors(const Stage& stage) const
{
  for (std::size_t place = 0; place < actorCount; ++place)
  {
    if (stage.shown[place])
    {
      stage.renderer->AddActor(this->props[place].actor);
    }
  }
}

/// In a row, so that each shadows the next.
vtkSmartPointer<vtkActor> SharedWindows::makeActor(std::size_t place, int shape)
{
  const auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(makeMapper(shape));
  const double x = 1.1 * (static_cast<double>(place) - 1.0);
  actor->SetPosition(x, -0.8 * x, 0.0);
  actor->GetProperty()->SetColor(0.9, 0.4 + 0.2 * static_cast<double>(place), 0.5);
  return actor;
}

vtkSmartPointer<vtkRenderPass> SharedWindows::makePass(Drawing drawing)
{
  switch (drawing)
  {
  case Drawing::Steps:
    return vtkSmartPointer<vtkRenderStepsPass>::New();
  case Drawing::Shadows:
    return vtkSmartPointer<vtkShadowVolumePass>::New();
  case Drawing::Lines:
    return vtkSmartPointer<vtkSilhouettePass>::New();
  case Drawing::LinesOverShadows:
  {
    const auto lines = vtkSmartPointer<vtkSilhouettePass>::New();
    lines->SetDelegatePass(makePass(Drawing::Shadows));
    return lines;
  }
  default:
    return nullptr;
  }
}

void SharedWindows::setDrawing(std::size_t one, Drawing drawing)
{
  this->stages[one].drawing = drawing;
  this->stages[one].renderer->SetPass(vtkOpenGLRenderPass::SafeDownCast(makePass(drawing)));
}

} // namespace shadow::test
