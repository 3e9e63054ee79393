// What may be done to windows that share.
#include "SharedWindows.h"

#include <utility>

#include <vtkMapper.h>
#include <vtkOpenGLRenderPass.h>

namespace shadow::test
{

const std::vector<SharedWindows::Operation>& SharedWindows::operations()
{
  static const std::vector<Operation> all = {
      {"a new shadow pass", true, &SharedWindows::newShadows},
      {"a new outline pass", true, &SharedWindows::newLines},
      {"new outlines over shadows", true, &SharedWindows::newLinesOverShadows},
      {"VTK's own passes", true, &SharedWindows::newSteps},
      {"no pass", true, &SharedWindows::noPass},
      {"the other window's pass", true, &SharedWindows::sharePass},
      {"the pass is kept", true, &SharedWindows::keepPass},
      {"the kept pass is dropped", true, &SharedWindows::dropKeptPass},
      {"a new window", false, &SharedWindows::replaceWindow},
      {"the window is closed", false, &SharedWindows::finalizeWindow},
      {"another size", false, &SharedWindows::resizeWindow},
      {"a new renderer", true, &SharedWindows::replaceRenderer},
      {"renderers change places", true, &SharedWindows::swapRenderers},
      {"the pass is released", true, &SharedWindows::releasePass},
      {"the renderer is released", true, &SharedWindows::releaseRenderer},
      {"an actor is released", true, &SharedWindows::releaseActor},
      {"an actor comes or goes", false, &SharedWindows::toggleActor},
      {"a new actor", false, &SharedWindows::replaceActor},
      {"the other actor's mapper", true, &SharedWindows::shareMapper},
      {"a new mapper", true, &SharedWindows::replaceMapper},
  };
  return all;
}

void SharedWindows::newShadows(std::size_t one, std::size_t)
{
  this->setDrawing(one, Drawing::Shadows);
}

void SharedWindows::newLines(std::size_t one, std::size_t)
{
  this->setDrawing(one, Drawing::Lines);
}

void SharedWindows::newLinesOverShadows(std::size_t one, std::size_t)
{
  this->setDrawing(one, Drawing::LinesOverShadows);
}

void SharedWindows::newSteps(std::size_t one, std::size_t)
{
  this->setDrawing(one, Drawing::Steps);
}

void SharedWindows::noPass(std::size_t one, std::size_t)
{
  this->setDrawing(one, Drawing::Plain);
}

void SharedWindows::sharePass(std::size_t one, std::size_t other)
{
  this->stages[one].drawing = this->stages[other].drawing;
  this->stages[one].renderer->SetPass(this->stages[other].renderer->GetPass());
}

void SharedWindows::keepPass(std::size_t one, std::size_t)
{
  this->kept = this->stages[one].renderer->GetPass();
}

void SharedWindows::dropKeptPass(std::size_t, std::size_t)
{
  this->kept = nullptr;
}

/// The renderer comes along.
void SharedWindows::replaceWindow(std::size_t one, std::size_t)
{
  Stage& stage = this->stages[one];
  stage.window->RemoveRenderer(stage.renderer);
  openWindow(stage);
  stage.window->AddRenderer(stage.renderer);
}

void SharedWindows::finalizeWindow(std::size_t one, std::size_t)
{
  this->stages[one].window->Finalize();
}

void SharedWindows::resizeWindow(std::size_t one, std::size_t other)
{
  Stage& stage = this->stages[one];
  stage.size = {60 + 11 * static_cast<int>(other) + stage.size[0] % 40, 60 + stage.size[1] % 30};
  stage.window->SetSize(stage.size[0], stage.size[1]);
}

void SharedWindows::replaceRenderer(std::size_t one, std::size_t)
{
  const vtkSmartPointer<vtkRenderPass> pass = this->stages[one].renderer->GetPass();
  makeRenderer(this->stages[one], pass);
  this->showActors(this->stages[one]);
}

void SharedWindows::swapRenderers(std::size_t one, std::size_t other)
{
  Stage& first = this->stages[one];
  Stage& second = this->stages[other];
  if (one == other)
  {
    return;
  }
  first.window->RemoveRenderer(first.renderer);
  second.window->RemoveRenderer(second.renderer);
  std::swap(first.renderer, second.renderer);
  std::swap(first.drawing, second.drawing);
  std::swap(first.shown, second.shown);
  first.window->AddRenderer(first.renderer);
  second.window->AddRenderer(second.renderer);
}

void SharedWindows::releasePass(std::size_t one, std::size_t other)
{
  if (vtkRenderPass* pass = this->stages[one].renderer->GetPass())
  {
    pass->ReleaseGraphicsResources(this->stages[one].window);
    pass->ReleaseGraphicsResources(this->stages[other].window);
  }
}

void SharedWindows::releaseRenderer(std::size_t one, std::size_t)
{
  this->stages[one].renderer->ReleaseGraphicsResources(this->stages[one].window);
}

void SharedWindows::releaseActor(std::size_t one, std::size_t other)
{
  this->props[one].actor->ReleaseGraphicsResources(this->stages[other].window);
}

void SharedWindows::toggleActor(std::size_t one, std::size_t other)
{
  Stage& stage = this->stages[one];
  vtkActor* actor = this->props[other].actor;
  stage.shown[other] = !stage.shown[other];
  if (stage.shown[other])
  {
    stage.renderer->AddActor(actor);
  }
  else
  {
    stage.renderer->RemoveActor(actor);
  }
}

/// In every window, at the place of the one that goes.
void SharedWindows::replaceActor(std::size_t one, std::size_t)
{
  const vtkSmartPointer<vtkActor> fresh = makeActor(one, this->shapes);
  for (Stage& stage : this->stages)
  {
    if (stage.shown[one])
    {
      stage.renderer->RemoveActor(this->props[one].actor);
      stage.renderer->AddActor(fresh);
    }
  }
  this->props[one] = {fresh, this->shapes};
  ++this->shapes;
}

void SharedWindows::shareMapper(std::size_t one, std::size_t other)
{
  this->props[one].actor->SetMapper(this->props[other].actor->GetMapper());
  this->props[one].shape = this->props[other].shape;
}

void SharedWindows::replaceMapper(std::size_t one, std::size_t)
{
  this->props[one].actor->SetMapper(makeActor(one, this->shapes)->GetMapper());
  this->props[one].shape = this->shapes;
  ++this->shapes;
}

} // namespace shadow::test
