// silhouetteSource.glsl - chunk: where the sides of volumes take the silhouette from.
// unif light            int   Light::index
// def  SHADOW_EDGE_TEXTURE      from a texture of the state of every edge: written by nodes/drawable/silhouettes/VertexTexture
// unif edgeStateTexels  usampler2DArray  see edgeStates.vert
// unif edgeStateLayer   ivec2            see texelArray.glsl
// def  SHADOW_SILHOUETTE_LIST   from a list of the edges on it: written by nodes/drawable/silhouettes/ComputeSilhouette
// unif listTexels       usampler2DArray  see silhouette.comp
// unif listLayer        ivec2
// unif listBegin        int              place of the light's first entry
// else from the facing of the two triangles of every edge
// unif lightFacingOnly  int   1: Casting::LightFacing
#include "facingSource.glsl"
uniform int light;
#if defined(SHADOW_EDGE_TEXTURE)
uniform usampler2DArray edgeStateTexels;
uniform ivec2 edgeStateLayer;

// How often the quad counts: 0 for an edge that is not on the silhouette, negative for one that is run through
// backwards. edge: the one it stands for.
int silhouetteAt(int quad, out int edge)
{
  edge = quad;
  uvec3 own = (texelFetch(edgeStateTexels, texelPlace(quad, edgeStateLayer), 0).xyz >> uint(light)) & 1u;
  return (int(own.x) - int(own.y)) * (1 + int(own.z));
}
#elif defined(SHADOW_SILHOUETTE_LIST)
uniform usampler2DArray listTexels;
uniform ivec2 listLayer;
uniform int listBegin;

int silhouetteAt(int quad, out int edge)
{
  uint entry = texelFetch(listTexels, texelPlace(listBegin + quad, listLayer), 0).x;
  edge = int(entry >> 2);
  return (1 - 2 * int(entry & 1u)) * (1 + int((entry >> 1) & 1u));
}
#else
uniform int lightFacingOnly;

int silhouetteAt(int quad, out int edge)
{
  edge = quad;
  uvec4 ends = edgeAt(edge);
  bool closed = lightFacingOnly == 1;
  int there = castingSign(facingBitsOf(int(ends.z)), light, closed);
  int back = ends.w == noTriangle ? 0 : castingSign(facingBitsOf(int(ends.w)), light, closed);
  return there - back;
}
#endif
