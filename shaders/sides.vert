//VTK::System::Dec
// sides.vert - sides of volumes, every edge of the mesh a quad that has an area only on the silhouette. Drawn by
// nodes/drawable/EdgeQuads: gl_VertexID = 5 * edge + corner; corners 0 to, 1 from, 2 far from, 3 far to, 4 the apex of a
// fan that closes the far end.
// unif light            int   Light::index
// unif lightFacingOnly  int   1: Casting::LightFacing
// unif apexMC           vec3  whose far copy is the apex
// out  multiplicity     float see volume.frag
// Source: McGuire & Hughes 2004, "Hardware-Determined Feature Edges"; Wallner 2006
#include "facingSource.glsl"
#include "extrusion.glsl"
uniform int light;
uniform int lightFacingOnly;
uniform vec3 apexMC;
flat out float multiplicity;
#ifdef SHADOW_PARALLEL
out float nearDistance;
#endif

void main()
{
  int edge = gl_VertexID / 5;
  int corner = gl_VertexID - 5 * edge;
  uvec4 ends = edgeAt(edge);
  bool closed = lightFacingOnly == 1;
  int there = castingSign(facingBitsOf(int(ends.z)), light, closed);
  int back = ends.w == noTriangle ? 0 : castingSign(facingBitsOf(int(ends.w)), light, closed);
  int times = there - back;
  multiplicity = abs(float(times));
#ifdef SHADOW_PARALLEL
  nearDistance = 1.0;
#endif
  if (times == 0)
  {
    gl_Position = vec4(0.0, 0.0, 0.0, 1.0);
    return;
  }
  bool atFrom = corner == 1 || corner == 2;
  vec3 vertexMC = corner == 4 ? apexMC : positionOf(atFrom == (times > 0) ? ends.x : ends.y);
  gl_Position = toClip(copyOf(vertexMC, corner >= 2));
}
