#include "SceneMaker.h"

#include <algorithm>

#include "ActorPoints.h"
#include "LightMaker.h"
#include "MeshMaker.h"

namespace shadow::fuzz
{

namespace
{

FuzzPlace makePlace(FuzzRandom& random)
{
  FuzzPlace place;
  if (random.chance(0.6))
  {
    place.scale = random.chance(0.3) ? powerOfTen(random.integer(-5, 6))
                                     : random.between(1.0, 10.0) * powerOfTen(random.integer(-5, 5));
  }
  if (random.chance(0.25))
  {
    place.offset = place.scale * powerOfTen(random.integer(0, 4)) * random.inCube(1.0);
  }
  return place;
}

/// Turned, stretched and maybe mirrored. The mesh comes to lie where it would without.
glm::dmat4 makeMatrix(FuzzRandom& random, const FuzzPlace& place)
{
  const glm::dvec3 x = random.direction();
  const glm::dvec3 y = glm::normalize(glm::cross(x, random.direction() + glm::dvec3(1e-3, 2e-3, 3e-3)));
  const double size = place.scale * (random.chance(0.5) ? 1.0 : powerOfTen(random.integer(-3, 3)));
  glm::dmat4 matrix(glm::dvec4(x, 0.0), glm::dvec4(y, 0.0), glm::dvec4(glm::cross(x, y), 0.0),
                    glm::dvec4(place.toWorld(random.inCube(0.5)), 1.0));
  for (int axis = 0; axis < 3; ++axis)
  {
    matrix[axis] *= size * random.between(0.3, 1.5);
  }
  if (random.chance(0.5))
  {
    matrix[0] = -matrix[0];
  }
  return matrix;
}

FuzzMesh makeActor(FuzzRandom& random, const FuzzScene& scene, const FuzzPlace& place)
{
  FuzzMesh mesh;
  if (!scene.meshes.empty() && random.chance(0.1))
  {
    mesh = scene.meshes.back(); // coincident
    if (random.chance(0.5))
    {
      for (FuzzTriangle& triangle : mesh.triangles)
      {
        std::swap(triangle[1], triangle[2]);
      }
    }
    return mesh;
  }
  mesh.triangles = makeMesh(random);
  const double size = random.chance(0.5) ? 1.0 : random.between(0.2, 1.5);
  const glm::dvec3 centre = random.chance(0.3) ? glm::dvec3(0.0) : random.inCube(1.5);
  for (FuzzTriangle& triangle : mesh.triangles)
  {
    for (glm::dvec3& corner : triangle)
    {
      corner = place.toWorld(centre + size * corner);
    }
  }
  if (random.chance(0.2))
  {
    mesh.worldFromMC = makeMatrix(random, place);
  }
  return mesh;
}

FuzzMesh makeFloor(FuzzRandom& random, const FuzzPlace& place)
{
  const double height = random.chance(0.3) ? 0.0 : -1.5;
  const auto at = [&](double x, double y) { return place.toWorld({6.0 * x, 6.0 * y, height}); };
  FuzzMesh floor;
  floor.triangles = {{at(-1, -1), at(1, -1), at(1, 1)}, {at(-1, -1), at(1, 1), at(-1, 1)}};
  return floor;
}

/// A point beyond a triangle as the light sees it.
glm::dvec3 behindTriangle(FuzzRandom& random, const FuzzScene& scene, const FuzzPlace& place)
{
  const FuzzTriangle& triangle = random.pick(random.pick(scene.meshes).triangles);
  const glm::dvec3 centre = (triangle[0] + triangle[1] + triangle[2]) / 3.0;
  const glm::dvec3 away = scene.light.positional ? centre - scene.light.position : -scene.light.position;
  const double length = glm::length(away);
  const double distance = random.between(0.1, 2.0) * place.scale;
  return centre + (length > 0.0 ? distance / length : 0.0) * away;
}

glm::dvec3 makeEye(FuzzRandom& random, const FuzzScene& scene, const FuzzPlace& place)
{
  switch (random.below(8))
  {
    case 0:
      return place.toWorld(random.inCube(1.5));
    case 1:
    {
      const FuzzTriangle& triangle = random.pick(random.pick(scene.meshes).triangles);
      return triangle[0] + 0.05 * place.scale * random.direction();
    }
    case 2:
    case 3:
      return behindTriangle(random, scene, place);
    default:
      return place.toWorld(random.between(1.5, 6.0) * random.direction());
  }
}

FuzzCamera makeCamera(FuzzRandom& random, const FuzzScene& scene, const FuzzPlace& place)
{
  FuzzCamera camera;
  camera.position = makeEye(random, scene, place);
  glm::dvec3 focus = place.toWorld(random.inCube(0.8));
  while (glm::distance(focus, camera.position) < 0.05 * place.scale)
  {
    focus = place.toWorld(random.inCube(2.0));
  }
  camera.focalPoint = focus;
  camera.viewUp = random.direction();
  camera.viewAngle = random.chance(0.6) ? 40.0 : random.chance(0.5) ? 5.0 : random.between(10.0, 100.0);
  if (random.chance(0.4))
  {
    camera.parallelScale = place.scale * (random.chance(0.5) ? 2.5 : random.between(0.3, 5.0));
  }
  const double distance = glm::distance(focus, camera.position);
  const bool isSection = random.chance(0.25);
  const double nearest = isSection ? random.between(0.4, 1.3) : random.chance(0.2) ? 0.001 : 0.1;
  camera.clippingRange = {nearest * distance, 100.0 * nearest * distance};
  return camera;
}

/// Four ways to draw the scene, of any silhouette method. Over many scenes all are dealt.
std::vector<FuzzConfig> dealConfigs(FuzzRandom& random)
{
  std::vector<FuzzConfig> configs(4);
  for (FuzzConfig& config : configs)
  {
    config.silhouette = random.integer(1, 13);
    config.stencil = random.integer(0, 2);
    config.compositing = random.integer(0, 1);
    config.countBuffer = random.integer(0, 2);
  }
  for (FuzzConfig& config : configs)
  {
    config.alone = random.chance(0.5);
  }
  return configs;
}

} // namespace

FuzzScene makeScene(std::uint64_t seed, std::uint64_t number)
{
  FuzzRandom random(seed, number);
  FuzzScene scene;
  scene.name = "seed-" + std::to_string(seed) + "-scene-" + std::to_string(number);
  scene.size = random.chance(0.1) ? glm::ivec2(90, 150) : glm::ivec2(160, 120);
  scene.doublePoints = random.chance(0.15);
  scene.sharedPoints = random.chance(0.5);
  const FuzzPlace place = makePlace(random);
  for (int actors = random.integer(1, 3); actors > 0; --actors)
  {
    scene.meshes.push_back(makeActor(random, scene, place));
  }
  if (random.chance(0.6))
  {
    scene.meshes.push_back(makeFloor(random, place));
  }
  roundAsActorsDo(scene);
  scene.light = makeLight(random, scene, place);
  scene.camera = makeCamera(random, scene, place);
  if (scene.light.positional && random.chance(0.03))
  {
    scene.light.position = scene.camera.position;
  }
  if (!scene.light.positional && random.chance(0.05))
  {
    scene.light.position = glm::normalize(scene.camera.position - scene.camera.focalPoint);
  }
  scene.configs = dealConfigs(random);
  return scene;
}

} // namespace shadow::fuzz
