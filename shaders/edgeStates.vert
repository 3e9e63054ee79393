//VTK::System::Dec
// edgeStates.vert - the silhouette state of every edge of one geometry for all lights. Drawn by
// nodes/drawable/silhouettes/VertexTexture through TexelPainter: each edge is a point, gl_VertexID its number.
// unif closedLights  uint   bits of the lights of Casting::LightFacing
// unif layerSize     ivec2  width and height of a layer of the texture
// out  texel         uvec4  xyz see silhouetteBits()
// def  SHADOW_NORMAL_PER_EDGE  as published: both normals from the four vertices of the edge, in single precision and
//                              in the edge's own order. The two edges of a vertex may then disagree on the triangle
//                              between them
// in   edgeVertices  uvec4  from, to, the third corners of the triangles that run so and back (or noTriangle)
// Source: Brabec & Seidel 2003, "Shadow Volumes on Programmable Graphics Hardware"
#include "precise.glsl"
#include "facingSource.glsl"
#include "edgeSilhouette.glsl"
uniform uint closedLights;
uniform ivec2 layerSize;
flat out uvec4 texel;
#ifdef SHADOW_NORMAL_PER_EDGE
in uvec4 edgeVertices;

uvec2 facingBitsOfCorners(vec3 a, vec3 b, vec3 c)
{
  vec3 normal = cross(b - a, c - a);
  uvec2 bits = uvec2(0u);
  for (int i = 0; i < lightCount; ++i)
  {
    float side = dot(normal, lightPosition[i].xyz - lightPosition[i].w * a);
    uint bit = 1u << uint(lightBit[i]);
    bits |= uvec2(side > 0.0 ? bit : 0u, side < 0.0 ? bit : 0u);
  }
  return bits;
}
#endif

void main()
{
#ifdef SHADOW_NORMAL_PER_EDGE
  vec3 from = facingScale * positionOf(edgeVertices.x);
  vec3 to = facingScale * positionOf(edgeVertices.y);
  uvec2 there = facingBitsOfCorners(from, to, facingScale * positionOf(edgeVertices.z));
  uvec2 back = uvec2(0u);
  if (edgeVertices.w != noTriangle)
  {
    back = facingBitsOfCorners(to, from, facingScale * positionOf(edgeVertices.w));
  }
#else
  uvec4 ends = edgeAt(gl_VertexID);
  uvec2 there = facingBitsOf(int(ends.z));
  uvec2 back = ends.w == noTriangle ? uvec2(0u) : facingBitsOf(int(ends.w));
#endif
  texel = uvec4(silhouetteBits(there, back, closedLights), 0u);
  vec2 centre = vec2(texelPlace(gl_VertexID, layerSize).xy) + 0.5;
  gl_Position = vec4(2.0 * centre / vec2(layerSize) - 1.0, 0.0, 1.0);
  gl_PointSize = 1.0;
}
