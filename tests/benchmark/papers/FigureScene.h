#pragma once

#include <vector>

#include "ShadowScene.h"

namespace shadow::benchmarks
{

/// What a point of a figure is drawn with.
struct SceneSize
{
  int objects = 1;
  int triangles = 1000; ///< of all objects and the floor, as near as whole rings of them come
  int lights = 1;
  int width = 640;
  int height = 480;
};

/// Balls in a ring on a floor under point lights that go round with every frame. The papers say how many
/// objects, triangles and lights there are, and not what they look like.
class FigureScene
{
public:
  explicit FigureScene(const SceneSize& size);

  /// Puts the lights where they are in this frame: equal frames, equal shadows.
  void moveLights(int frame);

  /// Draws a frame and waits for it. @return milliseconds
  double draw();

  truth::ShadowScene scene;

private:
  void addObjects(int objects, int triangles);

  std::vector<vtkLight*> lights;
};

} // namespace shadow::benchmarks
