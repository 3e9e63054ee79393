#pragma once

#include "FuzzScene.h"

namespace shadow::fuzz
{

/// A world point as the actor stores it: model space, rounded to single precision unless @p isDouble.
inline glm::dvec3 toActorPoint(const glm::dvec3& pointWC, const glm::dmat4& worldFromMC, bool isDouble)
{
  glm::dvec3 point = pointWC;
  if (worldFromMC != glm::dmat4(1.0))
  {
    point = glm::dvec3(glm::inverse(worldFromMC) * glm::dvec4(pointWC, 1.0));
  }
  return isDouble ? point : glm::dvec3(glm::vec3(point));
}

/// Moves all points to where the actors, which round theirs, have them.
inline void roundAsActorsDo(FuzzScene& scene)
{
  for (FuzzMesh& mesh : scene.meshes)
  {
    for (FuzzTriangle& triangle : mesh.triangles)
    {
      for (glm::dvec3& corner : triangle)
      {
        const glm::dvec3 point = toActorPoint(corner, mesh.worldFromMC, scene.doublePoints);
        corner = glm::dvec3(mesh.worldFromMC * glm::dvec4(point, 1.0));
      }
    }
  }
}

} // namespace shadow::fuzz
