//VTK::System::Dec
// adjacency.vert - corners for volume.geom. Drawn by nodes/drawable/silhouettes/AdjacentTriangles: vertex v is the geometry's vertex v.
// out  gl_Position   vec4  near copy, bit for bit where surface.vert has it, so that light caps lie on their surfaces
// out  farPosition   vec4  far copy in clip space
// out  vertexMC      vec3  relative to the geometry's origin
#include "geometryTexels.glsl"
#include "extrusion.glsl"
out vec3 vertexMC;
out vec4 farPosition;
invariant gl_Position;

void main()
{
  vertexMC = positionOf(uint(gl_VertexID));
  gl_Position = toClip(copyOf(vertexMC, false));
  farPosition = toClip(copyOf(vertexMC, true));
}
