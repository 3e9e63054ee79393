#include "KeptScene.h"

#include <vtkCamera.h>

namespace shadow::test
{

KeptScene::KeptScene() : ShadowScene(90, 70)
{
  this->source->SetCenter(0.0, 1.0, 0.0);
  this->source->SetThetaResolution(10);
  this->source->SetPhiResolution(10);
  this->ball = this->addSource(this->source);

  vtkNew<vtkSphereSource> second;
  second->SetRadius(0.3);
  second->SetCenter(-1.0, 0.8, 0.6);
  second->Update();
  this->points->DeepCopy(second->GetOutput());
  this->pointsActor = this->addPolyData(this->points);

  this->clipped = this->addMapper(this->makeBox(0.6, 1.0, 0.9, 0.8));
  this->clippingPlane->SetOrigin(1.0, 0.9, 0.8);
  this->clippingPlane->SetNormal(0.0, 1.0, 0.3);
  this->clipped->GetMapper()->AddClippingPlane(this->clippingPlane);

  for (unsigned block = 0; block < 2; ++block)
  {
    vtkNew<vtkCubeSource> cube;
    cube->SetXLength(0.4);
    cube->SetCenter(-0.8 + 0.9 * block, 0.6, -1.1);
    cube->Update();
    this->blocks->SetBlock(block, cube->GetOutput());
  }
  this->blockMapper->SetInputDataObject(this->blocks);
  vtkNew<vtkCompositeDataDisplayAttributes> attributes;
  this->blockMapper->SetCompositeDataDisplayAttributes(attributes);
  this->composite = this->addMapper(this->blockMapper);

  this->part->SetMapper(this->makeBox(0.4, 1.2, 1.4, -0.4));
  this->part->SetUserTransform(this->user);
  this->inner->AddPart(this->part);
  this->outer->AddPart(this->inner);
  this->outer->SetPosition(-0.2, 0.1, 0.1);
  this->renderer->AddActor(this->outer);

  this->floor = this->addFloor(1.6);
  this->lights[0] = this->addPointLight(1.5, 4.0, 1.0);
  this->lights[1] = this->addDirectionalLight(0.4, -1.0, -0.2);
  this->lights[2] = this->addPointLight(-2.0, 3.0, -0.5);
  this->lookFrom(0.3, 0.9, 1.0, 1.1);
}

vtkSmartPointer<vtkMapper> KeptScene::makeBox(double size, double x, double y, double z)
{
  vtkNew<vtkCubeSource> cube;
  cube->SetXLength(size);
  cube->SetYLength(size);
  cube->SetZLength(size);
  cube->SetCenter(x, y, z);
  auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
  mapper->SetInputConnection(cube->GetOutputPort());
  return mapper;
}

} // namespace shadow::test
