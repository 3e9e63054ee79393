#include "LightMaker.h"

namespace shadow::fuzz
{

namespace
{

const FuzzTriangle& pickTriangle(FuzzRandom& random, const FuzzScene& scene)
{
  return random.pick(random.pick(scene.meshes).triangles);
}

/// Of unit length, or any direction when the triangle has no area.
glm::dvec3 getNormal(FuzzRandom& random, const FuzzTriangle& triangle)
{
  const glm::dvec3 normal = glm::cross(triangle[1] - triangle[0], triangle[2] - triangle[0]);
  const double length = glm::length(normal);
  return length > 0.0 ? normal / length : random.direction();
}

glm::dvec3 getCentre(const FuzzMesh& mesh)
{
  glm::dvec3 sum(0.0);
  for (const FuzzTriangle& triangle : mesh.triangles)
  {
    sum += (triangle[0] + triangle[1] + triangle[2]) / 3.0;
  }
  return sum / static_cast<double>(mesh.triangles.size());
}

glm::dvec3 inFace(FuzzRandom& random, const FuzzTriangle& triangle)
{
  const double u = random.real();
  const double v = random.real() * (1.0 - u);
  return triangle[0] + u * (triangle[1] - triangle[0]) + v * (triangle[2] - triangle[0]);
}

/// A corner, a point of an edge, of the face or of its plane.
glm::dvec3 onTriangle(FuzzRandom& random, const FuzzTriangle& triangle)
{
  switch (random.below(4))
  {
    case 0:
      return random.pick(triangle);
    case 1:
      return triangle[0] + random.real() * (triangle[1] - triangle[0]);
    case 2:
      return inFace(random, triangle);
    default:
    {
      const double u = random.between(-3.0, 3.0);
      return triangle[0] + u * (triangle[1] - triangle[0]) +
             random.between(-3.0, 3.0) * (triangle[2] - triangle[0]);
    }
  }
}

glm::dvec3 makePosition(FuzzRandom& random, const FuzzScene& scene, const FuzzPlace& place)
{
  switch (random.below(10))
  {
    case 0:
    case 1:
      return place.toWorld(random.between(1.5, 5.0) * random.direction());
    case 2:
    case 3:
      return place.toWorld(random.inCube(1.5));
    case 4:
      return place.toWorld(100.0 * random.direction());
    case 5:
      return getCentre(random.pick(scene.meshes));
    case 6:
    case 7:
      return onTriangle(random, pickTriangle(random, scene));
    default:
    {
      const FuzzTriangle& triangle = pickTriangle(random, scene);
      const glm::dvec3 away = random.chance(0.7) ? getNormal(random, triangle) : random.direction();
      const double side = random.chance(0.5) ? 1.0 : -1.0;
      const double distance = random.between(1.0, 10.0) * powerOfTen(-random.integer(1, 13)) * place.scale;
      return onTriangle(random, triangle) + side * distance * away;
    }
  }
}

/// Towards the light.
glm::dvec3 makeDirection(FuzzRandom& random, const FuzzScene& scene)
{
  const FuzzTriangle& triangle = pickTriangle(random, scene);
  const glm::dvec3 side = triangle[1] - triangle[0];
  glm::dvec3 direction = random.direction();
  switch (random.below(8))
  {
    case 0:
      direction = glm::dvec3(0.0);
      direction[random.integer(0, 2)] = random.chance(0.5) ? 1.0 : -1.0;
      break;
    case 1:
      direction = side;
      break;
    case 2:
    {
      const double u = random.between(-1.0, 1.0);
      direction = u * side + random.between(-1.0, 1.0) * (triangle[2] - triangle[0]);
      break;
    }
    case 3:
    {
      const double length = glm::length(side);
      direction = (length > 0.0 ? side / length : direction) +
                  powerOfTen(-random.integer(2, 13)) * getNormal(random, triangle);
      break;
    }
    default:
      break;
  }
  const double length = glm::length(direction);
  return length > 0.0 ? direction / length : random.direction();
}

} // namespace

FuzzLight makeLight(FuzzRandom& random, const FuzzScene& scene, const FuzzPlace& place)
{
  FuzzLight light;
  switch (random.below(3))
  {
    case 0:
      light.positional = false;
      light.position = makeDirection(random, scene);
      break;
    case 1:
      light.position = makePosition(random, scene, place);
      break;
    default:
      light.position = makePosition(random, scene, place);
      light.coneAngle = random.chance(0.2) ? random.between(1.0, 179.0) : random.integer(1, 17) * 10.0;
      light.focalPoint = place.toWorld(random.inCube(0.5));
      break;
  }
  return light;
}

} // namespace shadow::fuzz
