// geometryTexels.glsl - chunk: the tables of a SEDGeometry. Bound by nodes/drawable/silhouettes/GeometryTexels.
// unif positionTexels  sampler2DArray   vertex: position relative to the geometry's origin
// unif triangleTexels  usampler2DArray  triangle: vertices in raster order; w = 1: oriented against it
// unif edgeTexels      usampler2DArray  edge: from, to, triangle that runs so, triangle that runs back or noTriangle
// unif ...Layer        ivec2            width and height of a layer: see texelArray.glsl
#include "texelArray.glsl"
uniform sampler2DArray positionTexels;
uniform usampler2DArray triangleTexels;
uniform usampler2DArray edgeTexels;
uniform ivec2 positionLayer;
uniform ivec2 triangleLayer;
uniform ivec2 edgeLayer;
const uint noTriangle = 0xffffffffu;

vec3 positionOf(uint vertex)
{
  return texelFetch(positionTexels, texelPlace(int(vertex), positionLayer), 0).xyz;
}

uvec4 triangleAt(int triangle)
{
  return texelFetch(triangleTexels, texelPlace(triangle, triangleLayer), 0);
}

uvec4 edgeAt(int edge)
{
  return texelFetch(edgeTexels, texelPlace(edge, edgeLayer), 0);
}
