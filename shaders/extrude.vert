//VTK::System::Dec
// extrude.vert - pre-pass and volume stage. Drawn by nodes/drawable/SEDGeometryDrawable and ShadowVolumeDrawable.
// One shader for both, so that a light cap gets bit for bit the depth of the surface it lies on.
// in   vertexMC    vec4  w = 1 near copy, w = 0 far copy of a vertex; relative to the geometry's origin
// unif clipFromMC  mat4  see shadowClipFromWC()
// unif lightMC     vec4  w = 1 position, w = 0 direction towards the light; volumes only
// unif nearFromMC  vec4  dot with the position: distance in front of the near plane; parallel views only
// Source: Everitt & Kilgard 2002
in vec4 vertexMC;
uniform mat4 clipFromMC;
uniform vec4 lightMC;
#ifdef SHADOW_PARALLEL
uniform vec4 nearFromMC;
out float nearDistance;
#endif
invariant gl_Position;

void main()
{
  vec4 positionMC = vec4(vertexMC.xyz, 1.0);
  if (vertexMC.w == 0.0)
  {
    positionMC = vec4(vertexMC.xyz * lightMC.w - lightMC.xyz, 0.0);
  }
#ifdef SHADOW_PARALLEL
  nearDistance = dot(nearFromMC, positionMC);
#endif
  gl_Position = clipFromMC * positionMC;
}
