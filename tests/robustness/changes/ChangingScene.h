#pragma once

#include <cstddef>
#include <vector>

#include <vtkActor.h>
#include <vtkAssembly.h>
#include <vtkHeadlessRenderWindow.h>
#include <vtkLight.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>
#include <vtkShadowVolumePass.h>
#include <vtkSmartPointer.h>
#include <vtkSphereSource.h>
#include <vtkTransform.h>

#include "FuzzRandom.h"

namespace shadow::fuzz
{

/// An actor and what can be changed of it. What is not there is nullptr.
struct ChangingActor
{
  vtkSmartPointer<vtkActor> actor;
  vtkSmartPointer<vtkPolyData> mesh;       ///< its own, to be changed in place
  vtkSmartPointer<vtkSphereSource> source; ///< that it is drawn from
  vtkSmartPointer<vtkTransform> user;      ///< its user transform
  vtkSmartPointer<vtkMatrix4x4> matrix;    ///< its user matrix, in place of that
  vtkSmartPointer<vtkPlane> plane;         ///< that clips it
  vtkSmartPointer<vtkAssembly> parent;     ///< none: it is the renderer's
};

/// A window with a renderer or two, drawn by one pass, and all that can be changed in it.
class ChangingScene
{
public:
  explicit ChangingScene(FuzzRandom& random);

  void addActor(FuzzRandom& random);
  void removeActor(std::size_t place);
  void addLight(FuzzRandom& random);

  /// Puts an actor into an assembly, or takes it out for nullptr.
  void setParent(ChangingActor& changing, vtkAssembly* parent);

  /// Has a second renderer, with the same props and lights, or has it no longer.
  void setSecond(bool wanted);

  ChangingActor& pickActor(FuzzRandom& random) { return this->actors[random.below(this->actors.size())]; }
  vtkLight* pickLight(FuzzRandom& random) { return this->lights[random.below(this->lights.size())]; }

  vtkNew<vtkHeadlessRenderWindow> window;
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkRenderer> second; ///< may be in no window
  vtkNew<vtkShadowVolumePass> pass;
  std::vector<ChangingActor> actors; ///< never empty
  std::vector<vtkSmartPointer<vtkAssembly>> assemblies;
  std::vector<vtkSmartPointer<vtkLight>> lights; ///< may be switched off; never empty
};

} // namespace shadow::fuzz
