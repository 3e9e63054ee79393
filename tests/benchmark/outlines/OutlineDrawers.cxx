#include "OutlineDrawers.h"

#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkCamera.h>
#include <vtkOutlineGlowPass.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataSilhouette.h>
#include <vtkProperty.h>
#include <vtkRenderStepsPass.h>
#include <vtkSilhouettePass.h>
#include <vtkUnsignedCharArray.h>

#include "Timing.h"

namespace shadow::benchmarks
{

namespace
{

constexpr double degreesAFrame = 3.0;

void addSurface(vtkRenderer* renderer, vtkPolyData* mesh)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(mesh);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  renderer->AddActor(actor);
}

void drawUnlit(vtkRenderer* renderer)
{
  vtkActorCollection* actors = renderer->GetActors();
  actors->InitTraversal();
  while (vtkActor* actor = actors->GetNextActor())
  {
    actor->GetProperty()->SetLighting(false);
  }
}

class PlainDrawer : public OutlineDrawer
{
public:
  PlainDrawer(vtkPolyData* mesh, int width, int height) : OutlineDrawer(mesh, width, height) {}
  std::string getName() const override { return "plain VTK"; }
};

class PassDrawer : public OutlineDrawer
{
public:
  PassDrawer(vtkPolyData* mesh, int width, int height) : OutlineDrawer(mesh, width, height)
  {
    this->renderer->SetPass(this->pass);
  }
  std::string getName() const override { return "vtkSilhouettePass"; }
  void setLineWidth(double width) override { this->pass->SetLineWidth(width); }

private:
  vtkNew<vtkSilhouettePass> pass;
};

/// The edges as a second actor of wide lines, moved a little towards the eye as VTK's users do it.
class FilterDrawer : public OutlineDrawer
{
public:
  FilterDrawer(vtkPolyData* mesh, int width, int height) : OutlineDrawer(mesh, width, height)
  {
    vtkMapper::SetResolveCoincidentTopologyToPolygonOffset();
    this->filter->SetInputData(mesh);
    this->filter->SetCamera(this->renderer->GetActiveCamera());
    this->filter->SetEnableFeatureAngle(0);
    this->filter->BorderEdgesOn();
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(this->filter->GetOutputPort());
    this->lines->SetMapper(mapper);
    this->lines->GetProperty()->SetColor(0.0, 0.0, 0.0);
    this->renderer->AddActor(this->lines);
  }
  std::string getName() const override { return "vtkPolyDataSilhouette"; }
  void setLineWidth(double width) override
  {
    this->lines->GetProperty()->SetLineWidth(static_cast<float>(width));
  }

private:
  vtkNew<vtkPolyDataSilhouette> filter;
  vtkNew<vtkActor> lines;
};

/// A second layer that glows over the first one.
class GlowDrawer : public OutlineDrawer
{
public:
  GlowDrawer(vtkPolyData* mesh, int width, int height) : OutlineDrawer(mesh, width, height)
  {
    this->window->SetNumberOfLayers(2);
    this->glowing->SetLayer(1);
    addSurface(this->glowing, mesh);
    drawUnlit(this->glowing);
    this->glowing->SetActiveCamera(this->renderer->GetActiveCamera());
    this->pass->SetDelegatePass(this->steps);
    this->glowing->SetPass(this->pass);
    this->window->AddRenderer(this->glowing);
  }
  std::string getName() const override { return "vtkOutlineGlowPass"; }
  bool hasLineWidth() const override { return false; }

  void useMaskColours() override
  {
    this->renderer->RemoveAllViewProps();
    this->renderer->SetBackground(0.0, 0.0, 0.0);
  }

  std::vector<unsigned char> readLines() override
  {
    std::vector<unsigned char> lines;
    const std::vector<unsigned char> picture = this->readPicture();
    for (std::size_t i = 0; i < picture.size(); i += 3)
    {
      lines.push_back(picture[i] >= 128 ? 255 : 0);
    }
    return lines;
  }

private:
  vtkNew<vtkRenderer> glowing;
  vtkNew<vtkOutlineGlowPass> pass;
  vtkNew<vtkRenderStepsPass> steps;
};

} // namespace

OutlineDrawer::OutlineDrawer(vtkPolyData* mesh, int width, int height)
{
  this->window->SetSize(width, height);
  this->window->SetMultiSamples(0);
  this->window->AddRenderer(this->renderer);
  this->renderer->SetBackground(1.0, 1.0, 1.0);
  addSurface(this->renderer, mesh);
}

void OutlineDrawer::useMaskColours()
{
  drawUnlit(this->renderer);
}

std::vector<unsigned char> OutlineDrawer::readPicture()
{
  this->window->Render();
  const int* size = this->window->GetSize();
  vtkNew<vtkUnsignedCharArray> pixels;
  this->window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, 0, pixels.GetPointer(), 0);
  return {pixels->GetPointer(0), pixels->GetPointer(0) + pixels->GetNumberOfValues()};
}

std::vector<unsigned char> OutlineDrawer::readLines()
{
  std::vector<unsigned char> lines;
  const std::vector<unsigned char> picture = this->readPicture();
  for (std::size_t i = 0; i < picture.size(); i += 3)
  {
    lines.push_back(picture[i] < 128 ? 255 : 0);
  }
  return lines;
}

double OutlineDrawer::drawNext()
{
  this->renderer->GetActiveCamera()->Azimuth(degreesAFrame);
  return measure(
      [this]
      {
        this->window->Render();
        this->window->WaitForCompletion();
      });
}

std::unique_ptr<OutlineDrawer> makePlainDrawer(vtkPolyData* mesh, int width, int height)
{
  return std::make_unique<PlainDrawer>(mesh, width, height);
}

std::unique_ptr<OutlineDrawer> makePassDrawer(vtkPolyData* mesh, int width, int height)
{
  return std::make_unique<PassDrawer>(mesh, width, height);
}

std::unique_ptr<OutlineDrawer> makeFilterDrawer(vtkPolyData* mesh, int width, int height)
{
  return std::make_unique<FilterDrawer>(mesh, width, height);
}

std::unique_ptr<OutlineDrawer> makeGlowDrawer(vtkPolyData* mesh, int width, int height)
{
  return std::make_unique<GlowDrawer>(mesh, width, height);
}

} // namespace shadow::benchmarks
