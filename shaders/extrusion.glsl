// extrusion.glsl - chunk: near and far copies of vertices in clip space.
// One function for all stages, so that a light cap gets bit for bit the depth of the surface it lies on.
// unif clipFromMC  mat4  see shadowClipFromWC()
// unif lightMC     vec4  w = 1 position, w = 0 direction towards the light; volumes only
// unif farPlaneMC  vec4  plane that far copies are projected on from the light; (0, 0, 0, 1) is the plane at infinity
// unif depthBias   vec2  x scales depth, y shifts it; (1, 0) leaves it as it is
// unif nearFromMC  vec4  dot with the position: distance in front of the near plane; parallel views only
// Source: Everitt & Kilgard 2002; Blinn 1988, "Me and My (Fake) Shadow" (projection onto a plane)
uniform mat4 clipFromMC;
uniform vec4 lightMC;
uniform vec4 farPlaneMC;
uniform vec2 depthBias;
#ifdef SHADOW_PARALLEL
uniform vec4 nearFromMC;
#endif

// Position of a copy in homogeneous model space. isFar: the far copy
vec4 copyOf(vec3 vertexMC, bool isFar)
{
  vec4 positionMC = vec4(vertexMC, 1.0);
  if (isFar)
  {
    positionMC = dot(farPlaneMC, lightMC) * positionMC - dot(farPlaneMC, positionMC) * lightMC;
  }
  return positionMC;
}

vec4 toClip(vec4 positionMC)
{
  vec4 position = clipFromMC * positionMC;
  position.z = position.z * depthBias.x + position.w * depthBias.y;
  return position;
}
