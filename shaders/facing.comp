#version 430
// facing.comp - the facing of the triangles of one geometry, one invocation each. Run by
// nodes/drawable/silhouettes/ComputeSilhouette.
// unif triangleCount  int
// unif facingImage    uimage2DArray  texel t: see facingBitsOf()
// unif imageLayer     ivec2          see texelArray.glsl
#include "precise.glsl"
#include "facingSource.glsl"
layout(local_size_x = 64) in;
#include "workItem.glsl"
layout(rg32ui, binding = 0) writeonly uniform uimage2DArray facingImage;
uniform int triangleCount;
uniform ivec2 imageLayer;

void main()
{
  int triangle = workItem();
  if (triangle < triangleCount)
  {
    imageStore(facingImage, texelPlace(triangle, imageLayer), uvec4(facingBitsOf(triangle), 0u, 0u));
  }
}
