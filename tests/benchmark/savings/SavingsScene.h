#pragma once

#include <string>
#include <vector>

#include <vtkCameraPass.h>

#include "ShadowScene.h"

namespace shadow::benchmarks
{

/// What changes from one frame to the next.
enum class Moves
{
  Nothing,
  Camera,
  Light,
  Actor
};

inline const std::vector<std::string>& namesOfMoves()
{
  static const std::vector<std::string> names = {"nothing", "camera", "light", "actor"};
  return names;
}

/// What a scene is made of.
struct SavingsSceneSize
{
  enum class Kind
  {
    Tori,    ///< each a mesh of its own
    Spheres, ///< actors of one mesh
    City     ///< boxes, each a mesh of its own, in streets
  };
  enum class Eye
  {
    Above,  ///< all of the scene fills the view
    Far,    ///< the scene fills a fifth of it
    Street  ///< among the boxes: most of them are outside the view, or hidden
  };

  std::string name;
  Kind kind = Kind::Tori;
  int objects = 1;
  int triangles = 10000; ///< of one torus or sphere, as near as whole rings of them come
  int lights = 1;
  Eye eye = Eye::Above;
  bool isMany = false; ///< for the aims: a frame of many actors
};

/// Objects on a floor under spot lights of 89 degrees, which shadow maps know, too.
class SavingsScene
{
public:
  /// @param width,height  of the window
  SavingsScene(const SavingsSceneSize& size, int width, int height);
  ~SavingsScene();
  SavingsScene(const SavingsScene&) = delete;
  SavingsScene& operator=(const SavingsScene&) = delete;

  /// Milliseconds of a frame by a pass, nullptr for none, that has drawn the one before.
  double draw(vtkRenderPass* pass, Moves moves);

  truth::ShadowScene scene; ///< its own pass is one that may draw
  vtkNew<vtkCameraPass> shadowMap;

private:
  void addTori(const SavingsSceneSize& size);
  void addSpheres(const SavingsSceneSize& size);
  void addCity(const SavingsSceneSize& size);
  void addLights(int count);
  void look(SavingsSceneSize::Eye eye);
  void place(vtkActor* actor, int number, int objects, double distance) const;
  void move(Moves moves);

  vtkActor* actor = nullptr; ///< that moves
  vtkLight* light = nullptr; ///< the same
  double size = 1.0;         ///< of the scene
  glm::dvec3 centre{0.0};
  int frame = 0;
};

} // namespace shadow::benchmarks
