#version 430
// silhouette.comp - the edges on the silhouettes of all lights, without gaps, and how many there are. Run by
// nodes/drawable/silhouettes/ComputeSilhouette, one invocation an edge.
// unif edgeCount     int
// unif lights        uint           bits of the lights asked about; the light with n lower ones has list n
// unif closedLights  uint           bits of the lights of Casting::LightFacing
// unif listImage     uimage2DArray  lists of edgeCount texels; an entry is 4 * edge + 2 if it counts twice
//                                   + 1 if it is run through backwards
// unif imageLayer    ivec2          see texelArray.glsl
// buf  commands      uint[]         ten a list: what glDrawElementsIndirect() takes for quads, then for fans
#include "precise.glsl"
#define SHADOW_FACING_TEXTURE
#include "facingSource.glsl"
#include "edgeSilhouette.glsl"
layout(local_size_x = 64) in;
#include "workItem.glsl"
layout(r32ui, binding = 0) writeonly uniform uimage2DArray listImage;
layout(std430, binding = 0) buffer Commands
{
  uint commands[];
};
uniform int edgeCount;
uniform uint lights;
uniform uint closedLights;
uniform ivec2 imageLayer;

void main()
{
  int edge = workItem();
  if (edge >= edgeCount)
  {
    return;
  }
  uvec4 ends = edgeAt(edge);
  uvec2 there = facingBitsOf(int(ends.z));
  uvec2 back = ends.w == noTriangle ? uvec2(0u) : facingBitsOf(int(ends.w));
  uvec3 state = silhouetteBits(there, back, closedLights);
  // Few edges are on any silhouette, so that counters are rarely asked.
  for (uint rest = state.x | state.y; rest != 0u; rest &= rest - 1u)
  {
    uint bit = rest & ~(rest - 1u);
    int list = bitCount(lights & (bit - 1u));
    uint place = atomicAdd(commands[10 * list], 6u) / 6u;
    atomicAdd(commands[10 * list + 5], 3u);
    uint entry = 4u * uint(edge) + ((state.z & bit) != 0u ? 2u : 0u) + ((state.y & bit) != 0u ? 1u : 0u);
    imageStore(listImage, texelPlace(list * edgeCount + int(place), imageLayer), uvec4(entry));
  }
}
