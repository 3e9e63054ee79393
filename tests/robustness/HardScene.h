#pragma once

#include <set>
#include <vector>

#include <glm/glm.hpp>

#include "ShadowScene.h"
#include "TestMeshes.h"

namespace shadow::robustness
{

/// A small scene for a hard case, y up, and what makes one up. Sizes are about 1, the floor is at y = 0.
class HardScene : public truth::ShadowScene
{
public:
  HardScene() : ShadowScene(400, 300) {}

  /// An actor for a mesh in double precision.
  vtkActor* addMesh(const TriangleSoup& soup);

  /// A closed cube that stands on the floor.
  vtkActor* addCube(const glm::dvec3& footMC, double size = 1.0);

  /// A parallelogram of two triangles.
  vtkActor* addPlate(const glm::dvec3& corner, const glm::dvec3& u, const glm::dvec3& v);

  /// A square floor at y = 0 around the origin.
  vtkActor* addGround(double half = 4.0);

  /// A cube and a ring on the ground.
  void addSolids();

  /// Ground, two lights and the camera around what is there.
  void finish();

  /// A mesh, and finish().
  void show(const TriangleSoup& soup);

  /// A point light and a directional light, both high and from the side.
  void addTwoLights();

  /// The camera, with a clipping range around all that is visible. To be called when all actors are there.
  void look(const glm::dvec3& eye, const glm::dvec3& focus, double angle = 35.0);

  /// look() from where most cases are seen: the ground in front, somewhat from above.
  void lookAtGround() { this->look({2.5, 4.0, 6.5}, {0.0, 0.4, 0.0}); }

  /// Actors that the pass has to refuse: it says so, and draws the shadows of the others as if they were not
  /// there.
  std::vector<vtkActor*> refused;

  /// Lights that the pass has to refuse, by their index among those that are switched on: their masks are all
  /// lit.
  std::set<int> refusedLights;
};

/// The same mesh turned from z up to y up; exact.
TriangleSoup upright(TriangleSoup soup);

TriangleSoup moved(TriangleSoup soup, const glm::dvec3& by);
TriangleSoup scaled(TriangleSoup soup, double by);

/// A torus that stands on the ground.
TriangleSoup makeRing();

/// Two triangles, corner to corner + u + v.
TriangleSoup makeQuad(const glm::dvec3& corner, const glm::dvec3& u, const glm::dvec3& v);

/// A quad in cells x cells parts of two triangles each; neighbours share no points.
TriangleSoup makeGrid(const glm::dvec3& corner, const glm::dvec3& u, const glm::dvec3& v, int cells);

/// A closed cube whose faces are grids.
TriangleSoup makeGridCube(const glm::dvec3& centre, double size, int cells);

/// The upper half of a sphere around the origin, y up, open below.
TriangleSoup makeDome(double radius, std::uint32_t slices);

} // namespace shadow::robustness
