#pragma once

#include <vtkActor.h>
#include <vtkAssembly.h>
#include <vtkCompositeDataDisplayAttributes.h>
#include <vtkCubeSource.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkPlane.h>
#include <vtkPlaneSource.h>
#include <vtkSphereSource.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkTransform.h>

#include "CompositeMapper.h"
#include "NewPass.h"
#include "ShadowScene.h"

namespace shadow::test
{

/// A scene with something of every kind that a mask depends on, under three lights.
class KeptScene : public truth::ShadowScene
{
public:
  KeptScene();

  static constexpr int lightCount = 3;

  vtkNew<vtkSphereSource> source;
  vtkActor* ball;                  ///< of the source
  vtkNew<vtkPolyData> points;      ///< a mesh without a source
  vtkActor* pointsActor;           ///< of those
  vtkActor* floor;
  vtkNew<vtkPlane> clippingPlane;
  vtkActor* clipped;               ///< by that
  vtkNew<vtkMultiBlockDataSet> blocks;
  vtkNew<truth::CompositeMapper> blockMapper;
  vtkActor* composite;             ///< of the blocks
  vtkNew<vtkAssembly> outer;
  vtkNew<vtkAssembly> inner;       ///< in outer
  vtkNew<vtkActor> part;           ///< in inner
  vtkNew<vtkTransform> user;       ///< the user transform of part
  vtkLight* lights[lightCount];    ///< point, directional, point

private:
  vtkSmartPointer<vtkMapper> makeBox(double size, double x, double y, double z);
};

} // namespace shadow::test
