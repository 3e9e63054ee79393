//VTK::System::Dec
// surface.vert - pre-pass and caps of volumes where the facing is known to the GPU only. Drawn by
// nodes/drawable/silhouettes/GPUSilhouette with the vertices of SEDGeometryDrawable: vertex t is the last of triangle t.
// in   vertexMC  vec3  relative to the geometry's origin
// unif triangleCount    int    vertices after these provoke nothing
// pre-pass:
// unif otherLights      uint   bits of lights that are not asked about: they reach every side
// caps, def SHADOW_CAP:
// unif light            int    Light::index
// unif lightFacingOnly  int    1: Casting::LightFacing
// unif farCap           int    0: light cap; 1: dark cap, of far copies
// out  multiplicity     float  how often a front face counts: 1, -1 for one wound clockwise seen from outside, 0
// def  SHADOW_HANDED_ON         surface.geom follows
#ifdef SHADOW_HANDED_ON
#define sideBits sideBitsOfCorner
#define nearDistance nearDistanceOfCorner
#endif
#include "precise.glsl"
#include "facingSource.glsl"
#include "extrusion.glsl"
in vec3 vertexMC;
uniform int triangleCount;
#ifdef SHADOW_CAP
uniform int light;
uniform int lightFacingOnly;
uniform int farCap;
flat out float multiplicity;
#else
uniform uint otherLights;
flat out uvec2 sideBits;
#endif
#ifdef SHADOW_PARALLEL
out float nearDistance;
#endif
invariant gl_Position;

void main()
{
  uvec2 bits = uvec2(0u);
  bool reversed = false;
  if (gl_VertexID < triangleCount)
  {
    bits = facingBitsOf(gl_VertexID);
    reversed = triangleAt(gl_VertexID).w == 1u;
  }
#ifdef SHADOW_CAP
  vec4 positionMC = copyOf(vertexMC, farCap == 1);
  int casts = castingSign(bits, light, lightFacingOnly == 1);
  if (farCap == 0)
  {
    multiplicity = float(reversed ? -casts : casts);
  }
  else if (lightFacingOnly == 1)
  {
    // The averted triangles of a closed mesh have the border of the others, the other way round.
    multiplicity = casts == 1 ? 0.0 : (reversed ? -1.0 : 1.0);
  }
  else
  {
    multiplicity = float(reversed ? casts : -casts);
  }
#else
  vec4 positionMC = copyOf(vertexMC, false);
  sideBits = (reversed ? bits.yx : bits) | otherLights;
#endif
#ifdef SHADOW_PARALLEL
  nearDistance = beyondNear(positionMC);
#endif
  gl_Position = toClip(positionMC);
}
