#include <vtkAssembly.h>
#include <vtkCompositeDataDisplayAttributes.h>
#include <vtkCompositePolyDataMapper.h>
#include <vtkConeSource.h>
#include <vtkCubeSource.h>
#include <vtkDataSetMapper.h>
#include <vtkFollower.h>
#include <vtkGenericRenderWindowInteractor.h>
#include <vtkGlyph3DMapper.h>
#include <vtkImageActor.h>
#include <vtkImageData.h>
#include <vtkImageProperty.h>
#include <vtkImageSlice.h>
#include <vtkImageSliceMapper.h>
#include <vtkLODProp3D.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkOpenGLGPUVolumeRayCastMapper.h>
#include <vtkPointData.h>
#include <vtkPointGaussianMapper.h>
#include <vtkPolyDataMapper.h>
#include <vtkPropAssembly.h>
#include <vtkProperty.h>
#include <vtkSkybox.h>
#include <vtkSmartVolumeMapper.h>
#include <vtkTexture.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include "../../../plugin/vtkShadowCompat.h"
#include "CompositeMapper.h"
#include "DropInCase.h"

#if VTKSHADOW_VTK_IS_WHOLE
#include <vtkLODActor.h>
#include <vtkOpenGLSphereMapper.h>
#include <vtkQuadricLODActor.h>
#endif

// Props of every kind that VTK draws in the scene.
namespace shadow::test
{

namespace
{

vtkSmartPointer<vtkPolyDataMapper> makeConeMapper(double height = 0.6)
{
  vtkNew<vtkConeSource> cone;
  cone->SetHeight(height);
  cone->SetRadius(0.3);
  cone->SetResolution(12);
  const auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
  mapper->SetInputConnection(cone->GetOutputPort());
  return mapper;
}

void place(vtkProp3D* prop)
{
  prop->SetPosition(1.0, 0.5, 0.6);
}

void addGlyphs(DropInScene& scene, double opacity)
{
  vtkNew<vtkGlyph3DMapper> mapper;
  vtkNew<vtkCubeSource> cube;
  mapper->SetInputConnection(scene.ball->GetOutputPort());
  mapper->SetSourceConnection(cube->GetOutputPort());
  mapper->SetScaleFactor(0.12);
  vtkActor* actor = scene.addMapper(mapper);
  actor->SetPosition(1.0, 0.0, 0.6);
  actor->GetProperty()->SetColor(0.8, 0.6, 0.1);
  actor->GetProperty()->SetOpacity(opacity);
}

#if VTKSHADOW_VTK_IS_WHOLE
template <class LevelsOfDetail>
void addActorWithLevels(DropInScene& scene)
{
  vtkNew<vtkGenericRenderWindowInteractor> interactor; // vtkQuadricLODActor asks it without looking
  interactor->SetRenderWindow(scene.window);
  scene.kept = {interactor};
  vtkNew<LevelsOfDetail> actor;
  actor->SetMapper(makeConeMapper());
  place(actor);
  scene.renderer->AddActor(actor);
}
#endif

void addLevels(DropInScene& scene)
{
  vtkNew<vtkLODProp3D> levels;
  levels->AddLOD(makeConeMapper(), 0.0);
  levels->AddLOD(makeConeMapper(0.3), 0.0);
  place(levels);
  scene.renderer->AddViewProp(levels);
}

void addFollower(DropInScene& scene)
{
  vtkNew<vtkFollower> follower;
  follower->SetMapper(makeConeMapper());
  follower->SetCamera(scene.renderer->GetActiveCamera());
  place(follower);
  scene.renderer->AddActor(follower);
}

void addImage(DropInScene& scene, double opacity)
{
  vtkNew<vtkImageActor> image;
  image->SetInputData(makeTexture()->GetInput());
  image->SetScale(0.08);
  image->SetPosition(0.5, 0.1, 0.8);
  image->SetOpacity(opacity);
  scene.renderer->AddActor(image);
}

void addSlice(DropInScene& scene)
{
  vtkNew<vtkImageSliceMapper> mapper;
  mapper->SetInputData(makeGrid());
  mapper->SetSliceNumber(7);
  vtkNew<vtkImageSlice> slice;
  slice->SetMapper(mapper);
  slice->GetProperty()->SetColorWindow(255.0);
  slice->GetProperty()->SetColorLevel(127.0);
  scene.renderer->AddViewProp(slice);
}

void addSkybox(DropInScene& scene)
{
  vtkNew<vtkSkybox> sky;
  sky->SetProjection(vtkSkybox::Sphere);
  sky->SetTexture(makeTexture());
  scene.renderer->AddActor(sky);
}

template <class Assembly>
void addAssembly(DropInScene& scene)
{
  vtkNew<Assembly> assembly;
  for (const double x : {0.8, 1.3})
  {
    vtkNew<vtkActor> part;
    part->SetMapper(makeConeMapper());
    part->SetPosition(x, 0.4, 0.6);
    assembly->AddPart(part);
  }
  scene.renderer->AddViewProp(assembly);
}

template <class Composite>
void addBlocks(DropInScene& scene, double opacity)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (unsigned int i = 0; i < 3; ++i)
  {
    vtkNew<vtkCubeSource> cube;
    cube->SetXLength(0.4);
    cube->SetCenter(-1.0 + i, 0.5, 1.0);
    cube->Update();
    blocks->SetBlock(i, cube->GetOutput());
  }
  vtkNew<Composite> mapper;
  mapper->SetInputDataObject(blocks);
  vtkActor* actor = scene.addMapper(mapper);
  actor->GetProperty()->SetColor(0.7, 0.4, 0.2);
  actor->GetProperty()->SetOpacity(opacity);
}

void colourBlocks(DropInScene& scene)
{
  addBlocks<truth::CompositeMapper>(scene, 1.0);
  auto* actor = vtkActor::SafeDownCast(scene.renderer->GetActors()->GetLastActor());
  auto* mapper = truth::CompositeMapper::SafeDownCast(actor->GetMapper());
  vtkNew<vtkCompositeDataDisplayAttributes> attributes;
  mapper->SetCompositeDataDisplayAttributes(attributes);
  mapper->SetBlockColor(1, 0.1, 0.9, 0.1);
  mapper->SetBlockOpacity(2, 0.4);
  mapper->SetBlockVisibility(3, false);
}

/// The first block opaque, the second translucent, the third without scalars.
void colourBlocksByScalars(DropInScene& scene)
{
  addBlocks<truth::CompositeMapper>(scene, 1.0);
  auto* actor = vtkActor::SafeDownCast(scene.renderer->GetActors()->GetLastActor());
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(actor->GetMapper()->GetInputDataObject(0, 0));
  for (unsigned int i = 0; i < 2; ++i)
  {
    vtkPointSet* block = vtkPointSet::SafeDownCast(blocks->GetBlock(i));
    vtkNew<vtkUnsignedCharArray> colours;
    colours->SetNumberOfComponents(4);
    for (vtkIdType point = 0; point < block->GetNumberOfPoints(); ++point)
    {
      colours->InsertNextTuple4(200, 80, 30, i == 0 ? 255 : 120);
    }
    block->GetPointData()->SetScalars(colours);
  }
}

void addGrid(DropInScene& scene)
{
  vtkNew<vtkPoints> points;
  for (const auto& corner :
       {std::array<double, 3>{0.6, 0.1, 0.6}, {1.4, 0.1, 0.6}, {1.0, 0.1, 1.2}, {1.0, 0.9, 0.8}})
  {
    points->InsertNextPoint(corner.data());
  }
  vtkNew<vtkUnstructuredGrid> grid;
  grid->SetPoints(points);
  const vtkIdType corners[] = {0, 1, 2, 3};
  grid->InsertNextCell(VTK_TETRA, 4, corners);
  vtkNew<vtkDataSetMapper> mapper;
  mapper->SetInputData(grid);
  scene.addMapper(mapper)->GetProperty()->SetColor(0.9, 0.5, 0.5);
}

template <class Splats>
void addSplats(DropInScene& scene)
{
  vtkNew<Splats> mapper;
  mapper->SetInputConnection(scene.ball->GetOutputPort());
  if constexpr (std::is_same_v<Splats, vtkPointGaussianMapper>)
  {
    mapper->SetScaleFactor(0.05);
  }
  else
  {
    mapper->SetRadius(0.08f);
  }
  scene.addMapper(mapper)->SetPosition(1.0, 0.0, 0.6);
}

} // namespace

std::vector<Row> propRows()
{
  return {
      {"glyphs", [](DropInScene& scene) { addGlyphs(scene, 1.0); }},
      {"glyphs_translucent", [](DropInScene& scene) { addGlyphs(scene, 0.4); }},
      {"gaussian_points", addSplats<vtkPointGaussianMapper>},
      {"lod_prop", addLevels},
#if VTKSHADOW_VTK_IS_WHOLE
      {"sphere_mapper", addSplats<vtkOpenGLSphereMapper>},
      {"lod_actor", addActorWithLevels<vtkLODActor>},
      {"quadric_lod_actor", addActorWithLevels<vtkQuadricLODActor>},
#endif
      {"follower", addFollower},
      {"image_actor", [](DropInScene& scene) { addImage(scene, 1.0); }},
      {"image_actor_translucent", [](DropInScene& scene) { addImage(scene, 0.5); }},
      {"image_slice", addSlice},
      {"volume_smart", [](DropInScene& scene) { addVolume(scene, vtkNew<vtkSmartVolumeMapper>(), false); }},
      {"volume_gpu",
       [](DropInScene& scene) { addVolume(scene, vtkNew<vtkOpenGLGPUVolumeRayCastMapper>(), true); }},
      {"volume_and_glass",
       [](DropInScene& scene)
       {
         addVolume(scene, vtkNew<vtkOpenGLGPUVolumeRayCastMapper>(), false);
         addGlass(scene, {0, 1, 0}, {0.9, 0.6, 1.0});
       }},
      {"skybox", addSkybox},
      {"assembly", addAssembly<vtkAssembly>},
      {"prop_assembly", addAssembly<vtkPropAssembly>},
      {"blocks", [](DropInScene& scene) { addBlocks<truth::CompositeMapper>(scene, 1.0); }},
      {"blocks_translucent", [](DropInScene& scene) { addBlocks<truth::CompositeMapper>(scene, 0.5); }},
      {"blocks_of_their_own_colours", colourBlocks},
      {"blocks_of_translucent_scalars", colourBlocksByScalars},
      {"blocks_one_by_one", [](DropInScene& scene) { addBlocks<vtkCompositePolyDataMapper>(scene, 1.0); }},
      {"unstructured_grid", addGrid},
  };
}

} // namespace shadow::test
