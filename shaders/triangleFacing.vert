//VTK::System::Dec
// triangleFacing.vert - the facing of the triangles of one geometry, from its tables. Drawn by
// nodes/drawable/silhouettes/VertexTexture through TexelPainter: each triangle is a point, gl_VertexID its number.
// unif layerSize  ivec2  width and height of a layer of the texture
// out  texel      uvec4  see facingBitsOf()
#include "precise.glsl"
#include "facingSource.glsl"
uniform ivec2 layerSize;
flat out uvec4 texel;

void main()
{
  texel = uvec4(facingBitsOf(gl_VertexID), 0u, 0u);
  vec2 centre = vec2(texelPlace(gl_VertexID, layerSize).xy) + 0.5;
  gl_Position = vec4(2.0 * centre / vec2(layerSize) - 1.0, 0.0, 1.0);
  gl_PointSize = 1.0;
}
