// facingSource.glsl - chunk: the facing of a triangle of the geometry that is drawn, for all lights.
// Gives bits as shaders/facing.vert does: x lights in front of the oriented triangle, y behind it.
// def  SHADOW_FACING_TEXTURE    from a texture: written by SilhouetteCamera or by a compute shader
// unif facingTexels   usampler2DArray
// unif facingLayer    ivec2   see texelArray.glsl
// unif firstTriangle  int     texel of the geometry's first triangle
// else evaluated from the corners in the tables of the geometry, for as many lights as are asked about
// unif facingScale    float   from positions to what lights are given in: GeometryTexels::getFrame()
// unif lightCount     int
// unif lightPosition  vec4[]  high part, and w; see SceneLight
// unif lightLow       vec3[]  low part
// unif lightBit       int[]   Light::index
#ifndef SHADOW_FACING_TEXTURE
#include "facing.glsl"
#endif
#include "geometryTexels.glsl"
#ifdef SHADOW_FACING_TEXTURE
uniform usampler2DArray facingTexels;
uniform ivec2 facingLayer;
uniform int firstTriangle;

uvec2 facingBitsOf(int triangle)
{
  return texelFetch(facingTexels, texelPlace(firstTriangle + triangle, facingLayer), 0).xy;
}
#else
uniform float facingScale;
uniform int lightCount;
uniform vec4 lightPosition[32];
uniform vec3 lightLow[32];
uniform int lightBit[32];

SplitVector cornerOf(vec3 positionMC)
{
  return SplitVector(facingScale * positionMC, vec3(0.0));
}

// a, b, c  corners in raster order, relative to the geometry's origin
// winding  1: the oriented triangle runs as they do; -1: against them
uvec2 facingBitsOf(vec3 a, vec3 b, vec3 c, float winding)
{
  FacingPlane plane = makeFacingPlane(cornerOf(a), cornerOf(b), cornerOf(c));
  uvec2 bits = uvec2(0u);
  for (int i = 0; i < lightCount; ++i)
  {
    float side = winding * facingOf(plane, SplitVector(lightPosition[i].xyz, lightLow[i]), lightPosition[i].w);
    uint bit = 1u << uint(lightBit[i]);
    bits |= uvec2(side > 0.0 ? bit : 0u, side < 0.0 ? bit : 0u);
  }
  return bits;
}

uvec2 facingBitsOf(int triangle)
{
  uvec4 corners = triangleAt(triangle);
  return facingBitsOf(positionOf(corners.x), positionOf(corners.y), positionOf(corners.z), corners.w == 1u ? -1.0 : 1.0);
}
#endif

// How the bits of one light cast: 1 as the triangle is oriented, -1 turned over, 0 not at all.
// lightFacingOnly  see Casting
int castingSign(uvec2 bits, int light, bool lightFacingOnly)
{
  uvec2 own = (bits >> uint(light)) & 1u;
  return own.x == 1u ? 1 : (own.y == 1u && !lightFacingOnly ? -1 : 0);
}
