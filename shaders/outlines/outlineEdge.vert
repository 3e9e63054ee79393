//VTK::System::Dec
// outlineEdge.vert - pass 2 of outlines, a rectangle around each edge that is a line. Drawn by
// nodes/effect/OutlineEffect: gl_VertexID = 6 * line + corner of two triangles.
// unif lines      usamplerBuffer  a line: face * 8 + edge * 2, and 1 where the surface is on both of its sides
// unif lineReach  float           pixels around an edge that may be drawn
// out  endsDC     vec4            pixels: from, to
// out  endsDepth  vec2            window depth there
// out  outwards   vec2            across the edge, away from the surface; zero where that is on both sides or not known
#include "outlines/outlineFaces.glsl"
uniform usamplerBuffer lines;
uniform float lineReach;
flat out vec4 endsDC;
flat out vec2 endsDepth;
flat out vec2 outwards;

void main()
{
  int line = gl_VertexID / 6;
  int vertex = gl_VertexID - 6 * line;
  int code = int(texelFetch(lines, line).x);
  int face = code / 8;
  int edge = code / 2 % 4;
  vec4 from;
  vec4 to;
  endsDC = vec4(0.0);
  endsDepth = vec2(0.0);
  outwards = vec2(0.0);
  gl_Position = vec4(0.0, 0.0, 0.0, 1.0);
  if (!clipEdge(cornerOf(face, edge), cornerOf(face, edge == 2 ? 0 : edge + 1), from, to))
  {
    return;
  }
  vec3 fromDC = toScreen(from);
  vec3 toDC = toScreen(to);
  endsDC = vec4(fromDC.xy, toDC.xy);
  endsDepth = vec2(fromDC.z, toDC.z);
  vec2 along = toDC.xy - fromDC.xy;
  float length = length(along);
  // An edge that is seen end on is a dot.
  along = length > 1e-4 ? along / length : vec2(1.0, 0.0);
  if (code % 2 == 0)
  {
    // Where the face begins on the screen, be its third corner behind the eye.
    vec4 third = toClip(cornerOf(face, edge == 0 ? 2 : edge - 1));
    float side = determinant(mat3(from.xyw, to.xyw, third.xyw));
    outwards = sign(side) * vec2(along.y, -along.x);
    // A face that is thinner on the screen than the grid vertices are snapped to, twice 1/256, does not tell.
    if (third.w > 0.0 && abs(dot(toScreen(third).xy - fromDC.xy, outwards)) < 0.008)
    {
      outwards = vec2(0.0);
    }
  }
  // Pixels are drawn whose centre is covered; vertices are snapped to 1/256 of a pixel.
  float margin = lineReach + 0.02;
  vec2 across = margin * vec2(-along.y, along.x);
  bool atTo = vertex == 1 || vertex == 2 || vertex == 4;
  bool left = vertex == 2 || vertex == 4 || vertex == 5;
  vec2 end = atTo ? toDC.xy + margin * along : fromDC.xy - margin * along;
  gl_Position = fromScreen(end + (left ? across : -across));
}
