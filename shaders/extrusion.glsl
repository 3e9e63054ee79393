// extrusion.glsl - chunk: near and far copies of vertices in clip space.
// One function for all stages, so that a light cap gets bit for bit the depth of the surface it lies on.
// unif clipFromMC  mat4  see shadowClipFromWC()
// unif lightMC     vec4  w = 1 position, w = 0 direction towards the light; volumes only
// unif lightLowMC  vec3  what lightMC lost when it was rounded to floats
// unif rayLength   float  how long the direction of a point light's ray is made at least: where it is much shorter than what is
//                         seen, as close to the light, what lies far along the ray would be the quotient of tiny differences
// unif farPlaneMC  vec4  plane that far copies are projected on from the light; (0, 0, 0, 1) is the plane at infinity
// unif depthBias   vec2  x scales depth, y shifts it; (1, 0) leaves it as it is
// unif nearFromMC  vec4  dot with the position: distance in front of the near plane; parallel views only
// def  SHADOW_BATCHED    all but depthBias are of the vertex's mesh: see batchedObject.glsl
// Stages include precise.glsl before it.
// Source: Everitt & Kilgard 2002; Blinn 1988, "Me and My (Fake) Shadow" (projection onto a plane)
uniform vec2 depthBias;
#ifdef SHADOW_BATCHED
#include "batchedObject.glsl"
#else
uniform mat4 clipFromMC;
uniform vec4 lightMC;
uniform vec3 lightLowMC;
uniform float rayLength;
uniform vec4 farPlaneMC;
#ifdef SHADOW_PARALLEL
uniform vec4 nearFromMC;
#endif
#endif

// Where a ray from the light meets the far plane, in homogeneous model space: w is negative where it would meet it only
// backwards, so that what lies between start and end goes on to infinity.
// start  a point of the ray
// rayMC  its direction, away from the light
vec4 endOf(vec4 startMC, vec3 rayMC)
{
  return dot(farPlaneMC, startMC) * vec4(rayMC, 0.0) - dot(farPlaneMC.xyz, rayMC) * startMC;
}

// Position of a copy in homogeneous model space. isFar: the far copy
vec4 copyOf(vec3 vertexMC, bool isFar)
{
  vec4 positionMC = vec4(vertexMC, 1.0);
  if (isFar)
  {
    // However close the light is to the vertex, the direction is off by a few roundings of itself only.
    SHADOW_PRECISE vec3 fromHigh = lightMC.w * vertexMC - lightMC.xyz;
    SHADOW_PRECISE vec3 rayMC = fromHigh - lightLowMC;
    vec3 size = abs(rayMC);
    float largest = max(max(size.x, size.y), size.z);
    if (lightMC.w == 0.0 || largest >= rayLength)
    {
      // Rays that meet in one point bit for bit make smoother sides, where the light is not close.
      return dot(farPlaneMC, lightMC) * positionMC - dot(farPlaneMC, positionMC) * lightMC;
    }
    // By a power of two, which rounds nothing.
    float longer = largest > 0.0 ? exp2(ceil(log2(rayLength / largest))) : 1.0;
    positionMC = endOf(positionMC, longer * rayMC);
  }
  return positionMC;
}

#ifdef SHADOW_PARALLEL
// Depth clamp is on in parallel views, so that volumes are not cut at their far end; they begin at the near plane all the same.
// nearFromMC as above; for stages of volumes
float beyondNear(vec4 positionMC)
{
  return dot(nearFromMC, positionMC);
}
#endif

vec4 toClip(vec4 positionMC)
{
  vec4 position = clipFromMC * positionMC;
  position.z = position.z * depthBias.x + position.w * depthBias.y;
  return position;
}
