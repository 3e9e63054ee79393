//VTK::System::Dec
// sides.vert - sides of volumes, quads that have an area only on the silhouette. Drawn by nodes/drawable/silhouettes/EdgeQuads:
// gl_VertexID = 5 * quad + corner; corners 0 to, 1 from, 2 far from, 3 far to, 4 the apex of a fan that closes the far
// end.
// unif apexMC        vec3   whose far copy is the apex
// out  multiplicity  float  see volume.frag
// out  nearDistance  float  see volume.frag; parallel views only
// Source: McGuire & Hughes 2004, "Hardware-Determined Feature Edges"; Wallner 2006
#include "precise.glsl"
#include "silhouetteSource.glsl"
#include "extrusion.glsl"
uniform vec3 apexMC;
flat out float multiplicity;
#ifdef SHADOW_PARALLEL
out float nearDistance;
#endif

void main()
{
  int quad = gl_VertexID / 5;
  int corner = gl_VertexID - 5 * quad;
  int edge;
  int times = silhouetteAt(quad, edge);
  multiplicity = abs(float(times));
  if (times == 0)
  {
    gl_Position = vec4(0.0, 0.0, 0.0, 1.0);
#ifdef SHADOW_PARALLEL
    nearDistance = 0.0;
#endif
    return;
  }
  uvec4 ends = edgeAt(edge);
  bool atFrom = corner == 1 || corner == 2;
  vec3 vertexMC = corner == 4 ? apexMC : positionOf(atFrom == (times > 0) ? ends.x : ends.y);
  vec4 positionMC = copyOf(vertexMC, corner >= 2);
#ifdef SHADOW_PARALLEL
  nearDistance = beyondNear(positionMC);
#endif
  gl_Position = toClip(positionMC);
}
