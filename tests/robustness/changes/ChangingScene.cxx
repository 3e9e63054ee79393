#include "ChangingScene.h"

#include <cmath>

#include <vtkCamera.h>
#include <vtkConeSource.h>
#include <vtkCubeSource.h>
#include <vtkPlaneSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

namespace shadow::fuzz
{

namespace
{

vtkSmartPointer<vtkPolyData> makeMesh(FuzzRandom& random)
{
  vtkSmartPointer<vtkPolyDataAlgorithm> source;
  switch (random.below(4))
  {
  case 0:
    source = vtkSmartPointer<vtkCubeSource>::New();
    break;
  case 1:
    source = vtkSmartPointer<vtkConeSource>::New();
    break;
  case 2:
    source = vtkSmartPointer<vtkPlaneSource>::New();
    break;
  default:
    source = vtkSmartPointer<vtkSphereSource>::New();
  }
  source->Update();
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->DeepCopy(source->GetOutput());
  return mesh;
}

} // namespace

ChangingScene::ChangingScene(FuzzRandom& random)
{
  this->window->SetSize(72, 54);
  for (vtkRenderer* each : {this->renderer.Get(), this->second.Get()})
  {
    each->AutomaticLightCreationOff();
    each->SetPass(this->pass);
  }
  this->window->AddRenderer(this->renderer);
  for (int i = 0; i < 2; ++i)
  {
    this->assemblies.push_back(vtkSmartPointer<vtkAssembly>::New());
  }
  this->renderer->AddActor(this->assemblies[0]);
  this->second->AddActor(this->assemblies[0]);
  this->assemblies[0]->AddPart(this->assemblies[1]);

  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-3.0, -1.0, -3.0);
  plane->SetPoint1(-3.0, -1.0, 3.0);
  plane->SetPoint2(3.0, -1.0, -3.0);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(plane->GetOutputPort());
  ChangingActor floor;
  floor.actor = vtkSmartPointer<vtkActor>::New();
  floor.actor->SetMapper(mapper);
  this->actors.push_back(floor);
  this->renderer->AddActor(floor.actor);
  this->second->AddActor(floor.actor);
  for (int i = 0; i < 4; ++i)
  {
    this->addActor(random);
  }
  for (int i = 0; i < 3; ++i)
  {
    this->addLight(random);
  }
  this->renderer->GetActiveCamera()->SetPosition(1.0, 3.0, 6.0);
  this->renderer->ResetCamera();
  this->second->SetActiveCamera(this->renderer->GetActiveCamera());
}

void ChangingScene::addActor(FuzzRandom& random)
{
  ChangingActor made;
  vtkNew<vtkPolyDataMapper> mapper;
  if (random.chance(0.4))
  {
    made.source = vtkSmartPointer<vtkSphereSource>::New();
    made.source->SetThetaResolution(random.integer(3, 12));
    mapper->SetInputConnection(made.source->GetOutputPort());
  }
  else
  {
    made.mesh = makeMesh(random);
    mapper->SetInputData(made.mesh);
  }
  made.actor = vtkSmartPointer<vtkActor>::New();
  made.actor->SetMapper(mapper);
  const glm::dvec3 place = random.inCube(1.2);
  made.actor->SetPosition(place.x, place.y, place.z);
  this->renderer->AddActor(made.actor);
  this->second->AddActor(made.actor);
  this->actors.push_back(made);
}

void ChangingScene::removeActor(std::size_t place)
{
  this->setParent(this->actors[place], nullptr);
  this->renderer->RemoveActor(this->actors[place].actor);
  this->second->RemoveActor(this->actors[place].actor);
  this->actors.erase(this->actors.begin() + static_cast<std::ptrdiff_t>(place));
}

void ChangingScene::addLight(FuzzRandom& random)
{
  auto light = vtkSmartPointer<vtkLight>::New();
  const glm::dvec3 place = 5.0 * random.direction();
  light->SetPosition(place.x, std::abs(place.y) + 1.0, place.z);
  light->SetPositional(random.chance(0.6));
  light->SetConeAngle(180.0);
  light->SetIntensity(0.5);
  this->renderer->AddLight(light);
  this->second->AddLight(light);
  this->lights.push_back(light);
}

void ChangingScene::setParent(ChangingActor& changing, vtkAssembly* parent)
{
  if (changing.parent != nullptr)
  {
    changing.parent->RemovePart(changing.actor);
  }
  else
  {
    this->renderer->RemoveActor(changing.actor);
    this->second->RemoveActor(changing.actor);
  }
  changing.parent = parent;
  if (parent != nullptr)
  {
    parent->AddPart(changing.actor);
  }
  else
  {
    this->renderer->AddActor(changing.actor);
    this->second->AddActor(changing.actor);
  }
}

void ChangingScene::setSecond(bool wanted)
{
  if (wanted == (this->window->HasRenderer(this->second) != 0))
  {
    return;
  }
  if (wanted)
  {
    this->window->AddRenderer(this->second);
    this->second->SetViewport(0.5, 0.0, 1.0, 1.0);
  }
  else
  {
    this->window->RemoveRenderer(this->second);
  }
  this->renderer->SetViewport(0.0, 0.0, wanted ? 0.5 : 1.0, 1.0);
}

} // namespace shadow::fuzz
