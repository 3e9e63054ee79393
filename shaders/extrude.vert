//VTK::System::Dec
// extrude.vert - pre-pass and volume stage. Drawn by nodes/drawable/SEDGeometryDrawable and ShadowVolumeDrawable.
// One shader for both, so that a light cap gets bit for bit the depth of the surface it lies on.
// in   vertexMC    vec4  w = 1 near copy, w = 0 far copy of a vertex; relative to the geometry's origin
// in   reachableBits  uvec2  pre-pass: of the triangle that this vertex is the last of; see prepass.frag
// unif clipFromMC  mat4  see shadowClipFromWC()
// unif lightMC     vec4  w = 1 position, w = 0 direction towards the light; volumes only
// unif farPlaneMC  vec4  plane that far copies are projected on from the light; (0, 0, 0, 1) is the plane at infinity
// unif depthBias   vec2  x scales depth, y shifts it; (1, 0) leaves it as it is
// unif nearFromMC  vec4  dot with the position: distance in front of the near plane; parallel views only
// Source: Everitt & Kilgard 2002; Blinn 1988, "Me and My (Fake) Shadow" (projection onto a plane)
in vec4 vertexMC;
uniform mat4 clipFromMC;
uniform vec4 lightMC;
uniform vec4 farPlaneMC;
uniform vec2 depthBias;
#ifdef SHADOW_PARALLEL
uniform vec4 nearFromMC;
out float nearDistance;
#endif
#ifdef SHADOW_PREPASS
in uvec2 reachableBits;
flat out uvec2 sideBits;
#endif
invariant gl_Position;

void main()
{
  vec4 positionMC = vec4(vertexMC.xyz, 1.0);
  if (vertexMC.w == 0.0)
  {
    positionMC = dot(farPlaneMC, lightMC) * positionMC - dot(farPlaneMC, positionMC) * lightMC;
  }
#ifdef SHADOW_PREPASS
  sideBits = reachableBits;
#endif
#ifdef SHADOW_PARALLEL
  nearDistance = dot(nearFromMC, positionMC);
#endif
  gl_Position = clipFromMC * positionMC;
  gl_Position.z = gl_Position.z * depthBias.x + gl_Position.w * depthBias.y;
}
