#include "DropInScene.h"

#include <algorithm>
#include <cmath>

#include <vtkColorTransferFunction.h>
#include <vtkCubeSource.h>
#include <vtkImageData.h>
#include <vtkMapper.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPropCollection.h>
#include <vtkProperty.h>
#include <vtkTexture.h>
#include <vtkVolume.h>
#include <vtkVolumeMapper.h>
#include <vtkVolumeProperty.h>

namespace shadow::test
{

DropInScene::DropInScene() : BallScene(160, 120)
{
  this->renderer->SetPass(nullptr);
  // This is of all mappers, and a row may have set it.
  vtkMapper::SetResolveCoincidentTopologyToDefault();
}

vtkActor* addBox(DropInScene& scene, double x, double z, double size)
{
  vtkNew<vtkCubeSource> cube;
  cube->SetXLength(size);
  cube->SetYLength(size);
  cube->SetZLength(size);
  cube->SetCenter(x, 0.5 * size, z);
  vtkActor* actor = scene.addSource(cube);
  actor->GetProperty()->SetColor(0.3, 0.5, 0.9);
  return actor;
}

vtkActor* addGlass(DropInScene& scene, const std::array<double, 3>& colour,
                   const std::array<double, 3>& centre)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(0.4);
  sphere->SetThetaResolution(16);
  sphere->SetPhiResolution(12);
  vtkActor* actor = scene.addSource(sphere);
  actor->SetPosition(centre[0], centre[1], centre[2]);
  actor->GetProperty()->SetColor(colour[0], colour[1], colour[2]);
  actor->GetProperty()->SetOpacity(0.5);
  return actor;
}

vtkSmartPointer<vtkTexture> makeTexture(int components)
{
  constexpr int size = 16;
  vtkNew<vtkImageData> image;
  image->SetDimensions(size, size, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, components);
  for (int y = 0; y < size; ++y)
  {
    for (int x = 0; x < size; ++x)
    {
      auto* texel = static_cast<unsigned char*>(image->GetScalarPointer(x, y, 0));
      const std::array<int, 4> values{16 * x, 16 * y, 255 - 8 * (x + y), 8 * (x + y)};
      std::copy_n(values.begin(), components, texel);
    }
  }
  const auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputData(image);
  texture->InterpolateOn();
  return texture;
}

vtkSmartPointer<vtkImageData> makeGrid(int size)
{
  const auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(size, size, size);
  image->SetSpacing(1.0 / size, 1.0 / size, 1.0 / size);
  image->SetOrigin(0.6, 0.1, 0.2);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  const double middle = 0.5 * (size - 1);
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const double distance =
        std::hypot(i % size - middle, i / size % size - middle, i / (size * size) - middle);
    static_cast<unsigned char*>(image->GetScalarPointer())[i] =
        static_cast<unsigned char>(std::max(0.0, 255.0 * (1.0 - distance / middle)));
  }
  return image;
}

void addVolume(DropInScene& scene, vtkVolumeMapper* mapper, bool shaded)
{
  mapper->SetInputData(makeGrid());
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(20.0, 0.0);
  opacity->AddPoint(255.0, 0.6);
  vtkNew<vtkColorTransferFunction> colour;
  colour->AddRGBPoint(0.0, 0.1, 0.2, 0.9);
  colour->AddRGBPoint(255.0, 1.0, 0.4, 0.1);
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  volume->GetProperty()->SetScalarOpacity(opacity);
  volume->GetProperty()->SetColor(colour);
  volume->GetProperty()->SetShade(shaded);
  volume->GetProperty()->SetInterpolationTypeToLinear();
  scene.renderer->AddViewProp(volume);
}

} // namespace shadow::test
