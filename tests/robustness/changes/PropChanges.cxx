// What happens to props.
#include "Changes.h"

#include <algorithm>

#include <vtkCellArray.h>
#include <vtkImageData.h>
#include <vtkMapper.h>
#include <vtkPoints.h>
#include <vtkProperty.h>
#include <vtkTexture.h>

namespace shadow::fuzz
{

namespace
{

/// Places, turns or scales a prop.
void place(vtkProp3D* prop, FuzzRandom& random)
{
  const glm::dvec3 to = random.inCube(0.4);
  switch (random.below(4))
  {
  case 0:
    prop->SetPosition(to.x, to.y, to.z);
    break;
  case 1:
    prop->RotateWXYZ(random.between(5.0, 90.0), to.x, to.y, to.z);
    break;
  case 2:
    prop->SetOrigin(to.x, to.y, to.z);
    break;
  default:
    prop->SetScale(random.chance(0.2) ? -0.8 : random.between(0.5, 1.3), random.between(0.5, 1.3), 1.0);
  }
}

void deform(ChangingScene& scene, FuzzRandom& random)
{
  const ChangingActor& changing = scene.pickActor(random);
  if (changing.mesh == nullptr)
  {
    return;
  }
  vtkPoints* points = changing.mesh->GetPoints();
  const glm::dvec3 shear = random.inCube(0.3);
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double point[3];
    points->GetPoint(i, point);
    points->SetPoint(i, point[0] + shear.x * point[1], point[1] + shear.y, point[2] + shear.z * point[0]);
  }
  random.chance(0.5) ? points->Modified() : changing.mesh->Modified();
}

void changeCells(ChangingScene& scene, FuzzRandom& random)
{
  const ChangingActor& changing = scene.pickActor(random);
  if (changing.mesh == nullptr || changing.mesh->GetNumberOfPolys() < 2)
  {
    return;
  }
  vtkNew<vtkCellArray> cells;
  const auto left = random.below(static_cast<std::size_t>(changing.mesh->GetNumberOfPolys()));
  for (vtkIdType i = 0; i < changing.mesh->GetNumberOfPolys(); ++i)
  {
    vtkIdType count = 0;
    const vtkIdType* corners = nullptr;
    changing.mesh->GetPolys()->GetCellAtId(i, count, corners);
    if (i != static_cast<vtkIdType>(left))
    {
      cells->InsertNextCell(count, corners);
    }
  }
  changing.mesh->SetPolys(cells);
}

void changeUserTransform(ChangingScene& scene, FuzzRandom& random)
{
  ChangingActor& changing = scene.pickActor(random);
  const glm::dvec3 by = random.inCube(0.3);
  if (changing.user == nullptr)
  {
    changing.matrix = nullptr;
    changing.user = vtkSmartPointer<vtkTransform>::New();
    changing.actor->SetUserTransform(changing.user);
  }
  changing.user->Translate(by.x, by.y, by.z);
}

void changeUserMatrix(ChangingScene& scene, FuzzRandom& random)
{
  ChangingActor& changing = scene.pickActor(random);
  if (changing.matrix == nullptr || random.chance(0.3))
  {
    changing.user = nullptr;
    changing.matrix = vtkSmartPointer<vtkMatrix4x4>::New();
    changing.actor->SetUserMatrix(changing.matrix);
  }
  changing.matrix->SetElement(random.integer(0, 2), 3, random.between(-0.4, 0.4));
}

void clip(ChangingScene& scene, FuzzRandom& random)
{
  ChangingActor& changing = scene.pickActor(random);
  if (changing.plane != nullptr && random.chance(0.3))
  {
    changing.actor->GetMapper()->RemoveAllClippingPlanes();
    changing.plane = nullptr;
    return;
  }
  if (changing.plane == nullptr)
  {
    changing.plane = vtkSmartPointer<vtkPlane>::New();
    changing.actor->GetMapper()->AddClippingPlane(changing.plane);
  }
  const glm::dvec3 normal = random.direction();
  changing.plane->SetNormal(normal.x, normal.y, normal.z);
}

void changeTexture(ChangingScene& scene, FuzzRandom& random)
{
  vtkActor* actor = scene.pickActor(random).actor;
  if (actor->GetTexture() != nullptr)
  {
    actor->SetTexture(nullptr);
    return;
  }
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 2, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  const unsigned char alpha = random.chance(0.5) ? 255 : 90;
  std::fill_n(static_cast<unsigned char*>(image->GetScalarPointer()), 16, alpha);
  vtkNew<vtkTexture> texture;
  texture->SetInputData(image);
  actor->SetTexture(texture);
}

void changeProperty(ChangingScene& scene, FuzzRandom& random)
{
  vtkProperty* property = scene.pickActor(random).actor->GetProperty();
  switch (random.below(7))
  {
  case 0:
    property->SetOpacity(random.chance(0.6) ? 1.0 : 0.5);
    break;
  case 1:
    property->SetRepresentation(random.chance(0.7) ? VTK_SURFACE : VTK_WIREFRAME);
    break;
  case 2:
    property->SetBackfaceCulling(random.chance(0.5));
    break;
  case 3:
    property->SetFrontfaceCulling(random.chance(0.5));
    break;
  case 4:
    property->SetColor(random.real(), random.real(), random.real());
    break;
  case 5:
    property->SetEdgeVisibility(random.chance(0.3));
    break;
  default:
    property->SetLighting(random.chance(0.8));
  }
}

void shareMapper(ChangingScene& scene, FuzzRandom& random)
{
  const ChangingActor& from = scene.pickActor(random);
  ChangingActor& to = scene.pickActor(random);
  to.actor->SetMapper(from.actor->GetMapper());
  to.mesh = from.mesh;
  to.source = from.source;
  to.plane = from.plane;
}

} // namespace

std::vector<Change> listPropChanges()
{
  return {
      {"actor added",
       [](ChangingScene& s, FuzzRandom& r)
       {
         if (s.actors.size() < 9)
         {
           s.addActor(r);
         }
       }},
      {"actor removed",
       [](ChangingScene& s, FuzzRandom& r)
       {
         if (s.actors.size() > 3)
         {
           s.removeActor(r.below(s.actors.size()));
         }
       }},
      {"actor moved", [](ChangingScene& s, FuzzRandom& r) { place(s.pickActor(r).actor, r); }},
      {"actor moved", [](ChangingScene& s, FuzzRandom& r) { place(s.pickActor(r).actor, r); }},
      {"user transform", changeUserTransform},
      {"user matrix", changeUserMatrix},
      {"points deformed", deform},
      {"cells changed", changeCells},
      {"source's parameter",
       [](ChangingScene& s, FuzzRandom& r)
       {
         const ChangingActor& changing = s.pickActor(r);
         if (changing.source != nullptr)
         {
           changing.source->SetRadius(r.between(0.2, 0.9));
         }
       }},
      {"clipping plane", clip},
      {"texture", changeTexture},
      {"property", changeProperty},
      {"property", changeProperty},
      {"property replaced",
       [](ChangingScene& s, FuzzRandom& r) { s.pickActor(r).actor->SetProperty(vtkNew<vtkProperty>()); }},
      {"actor shown or hidden",
       [](ChangingScene& s, FuzzRandom& r) { s.pickActor(r).actor->SetVisibility(r.chance(0.6)); }},
      {"mapper of another", shareMapper},
      {"assembly moved", [](ChangingScene& s, FuzzRandom& r) { place(r.pick(s.assemblies), r); }},
      {"assembly shown or hidden",
       [](ChangingScene& s, FuzzRandom& r) { r.pick(s.assemblies)->SetVisibility(r.chance(0.7)); }},
      {"into an assembly",
       [](ChangingScene& s, FuzzRandom& r) { s.setParent(s.pickActor(r), r.pick(s.assemblies)); }},
      {"out of an assembly", [](ChangingScene& s, FuzzRandom& r) { s.setParent(s.pickActor(r), nullptr); }},
      {"casting",
       [](ChangingScene& s, FuzzRandom& r) { s.pass->SetCasting(s.pickActor(r).actor, r.chance(0.6)); }},
      {"casting of an assembly",
       [](ChangingScene& s, FuzzRandom& r) { s.pass->SetCasting(r.pick(s.assemblies), r.chance(0.7)); }}};
}

} // namespace shadow::fuzz
