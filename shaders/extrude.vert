//VTK::System::Dec
// extrude.vert - pre-pass and volume stage. Drawn by nodes/drawable/surfaces/SEDGeometryDrawable and ShadowVolumeDrawable.
// in   vertexMC       vec4   w = 1 near copy, w = 0 far copy of a vertex, relative to the geometry's origin; w = -1 direction of
//                            a ray from the light to the far end
// in   reachableBits  uvec2  pre-pass: of the triangle that this vertex is the last of; see prepass.frag
// def  SHADOW_HANDED_ON      volumeHandedOn.geom follows
#ifdef SHADOW_HANDED_ON
#define nearDistance nearDistanceOfCorner
#endif
#include "precise.glsl"
#include "extrusion.glsl"
in vec4 vertexMC;
#ifdef SHADOW_PARALLEL
out float nearDistance;
#endif
#ifdef SHADOW_PREPASS
in uvec2 reachableBits;
flat out uvec2 sideBits;
#endif
invariant gl_Position;

void main()
{
#ifdef SHADOW_BATCHED
  readObject();
#endif
#ifdef SHADOW_PREPASS
  vec4 positionMC = copyOf(vertexMC.xyz, false);
  sideBits = reachableBits;
#else
  vec4 positionMC = vertexMC.w < 0.0 ? endOf(lightMC, rayLength * vertexMC.xyz) : copyOf(vertexMC.xyz, vertexMC.w == 0.0);
#endif
#ifdef SHADOW_PARALLEL
  nearDistance = beyondNear(positionMC);
#endif
  gl_Position = toClip(positionMC);
}
