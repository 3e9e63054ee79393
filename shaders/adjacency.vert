//VTK::System::Dec
// adjacency.vert - corners for volume.geom. Drawn by nodes/drawable/silhouettes/AdjacentTriangles: vertex v is the geometry's vertex v.
// out  gl_Position   vec4  near copy, bit for bit where surface.vert has it, so that light caps lie on their surfaces
// out  farPosition   vec4  far copy in clip space
// out  vertexMC      vec3  relative to the geometry's origin
// out  beyondNearOfCopies  vec2  of the near and the far copy, see extrusion.glsl; parallel views only
#include "precise.glsl"
#include "geometryTexels.glsl"
#include "extrusion.glsl"
out vec3 vertexMC;
out vec4 farPosition;
#ifdef SHADOW_PARALLEL
out vec2 beyondNearOfCopies;
#endif
invariant gl_Position;

void main()
{
  vertexMC = positionOf(uint(gl_VertexID));
  vec4 nearMC = copyOf(vertexMC, false);
  vec4 farMC = copyOf(vertexMC, true);
  gl_Position = toClip(nearMC);
  farPosition = toClip(farMC);
#ifdef SHADOW_PARALLEL
  beyondNearOfCopies = vec2(beyondNear(nearMC), beyondNear(farMC));
#endif
}
