//VTK::System::Dec
// outlineFace.vert - pass 2 of outlines, a whole topology-aware mesh. Drawn by nodes/drawable/surfaces/SEDGeometryDrawable.
// A face tells by the normals it stores which of its edges are lines, and is scaled on the screen about its incentre
// until it covers them; a large one is drawn as thin triangles along them instead, where they cover less.
// unif splits           int             0: gl_VertexID = 3 * face + corner; 1: 9 * face + 3 * edge + corner, draws those
//                                       that 0 has left out for being large
// unif splitFrom        float           model space: faces without an edge so long are not large
// unif normalTexels     usamplerBuffer  three texels a face: TAMLayout::Shared
// unif eyeMC            vec4            relative to the geometry's origin; w = 0: direction towards it
// unif drawsSilhouette  int             1: edges whose faces face the eye differently
// unif drawsBorder      int             1: edges without a neighbour
// unif creaseCosine     float           edges whose faces' normals have a smaller cosine; -2: none
// unif lineReach        float           pixels around an edge that may be drawn
// out  lineCount                    int  edges that are lines
// out  endsDC, endsDepth, outwards  of each of them: see outlineEdge.vert
// Source: Valient, "Hardware Generated Object Silhouettes", section 3.1
#include "outlines/outlineFaces.glsl"
uniform int splits;
uniform float splitFrom;
uniform usamplerBuffer normalTexels;
uniform vec4 eyeMC;
uniform int drawsSilhouette;
uniform int drawsBorder;
uniform float creaseCosine;
uniform float lineReach;
flat out int lineCount;
flat out vec4 endsDC[3];
flat out vec2 endsDepth[3];
flat out vec2 outwards[3];

// A pixel's diagonal.
const float diagonal = 1.4142136;
// Vertices are snapped to 1/256 of a pixel.
const float snap = 0.02;
// Stand for normals, see TopologyAwareMesh.h.
const uint neverPacked = 0x80008000u;
const uint borderPacked = 0x80000000u;

// Octahedral, see packNormal(). Source: Meyer et al. 2010, "On Floating-Point Normal Vectors"
vec3 unpackNormal(uint code)
{
  vec2 flat2 = max(vec2(int(code << 16u) >> 16, int(code) >> 16) / 32767.0, -1.0);
  vec3 normal = vec3(flat2, 1.0 - abs(flat2.x) - abs(flat2.y));
  if (normal.z < 0.0)
  {
    normal.xy = (1.0 - abs(flat2.yx)) * vec2(flat2.x >= 0.0 ? 1.0 : -1.0, flat2.y >= 0.0 ? 1.0 : -1.0);
  }
  return normalize(normal);
}

// Which kind of line an edge is. 0 none, 1 silhouette or border, 2 crease with the surface on both sides
int kindOf(vec3 own, uint code, vec3 toEye)
{
  if (code == borderPacked)
  {
    return drawsBorder;
  }
  // A face without area has no side of its own: its neighbours store the normal beyond it, and have its lines.
  if (code == neverPacked || own == vec3(0.0))
  {
    return 0;
  }
  vec3 other = unpackNormal(code);
  bool differs = dot(own, toEye) > 0.0 != dot(other, toEye) > 0.0;
  return differs && drawsSilhouette == 1 ? 1 : (dot(own, other) < creaseCosine ? 2 : 0);
}

// Moves the corners of a triangle that is thin or tiny on the screen apart, so that it has an inside to be scaled; the
// old triangle stays within the new one.
void widen(inout vec2 corners[3])
{
  int apex = 0;
  float longest = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    float length = distance(corners[(i + 1) % 3], corners[(i + 2) % 3]);
    if (length >= longest)
    {
      longest = length;
      apex = i;
    }
  }
  vec2 first = corners[(apex + 1) % 3];
  vec2 along = longest > 1e-4 ? (corners[(apex + 2) % 3] - first) / longest : vec2(1.0, 0.0);
  vec2 across = vec2(-along.y, along.x);
  float height = dot(corners[apex] - first, across);
  corners[apex] += across * (height >= 0.0 ? 1.0 : -1.0) * 3.0 * diagonal;
  corners[(apex + 1) % 3] -= 2.0 * diagonal * along;
  corners[(apex + 2) % 3] += 2.0 * diagonal * along;
}

float inradiusOf(vec2 corners[3], vec3 lengths)
{
  float area = abs(determinant(mat2(corners[1] - corners[0], corners[2] - corners[0])));
  return area > 0.0 ? area / (lengths.x + lengths.y + lengths.z) : 0.0;
}

vec3 lengthsOf(vec2 corners[3])
{
  return vec3(distance(corners[1], corners[2]), distance(corners[2], corners[0]), distance(corners[0], corners[1]));
}

// Scales a triangle about its incentre, so that everything near it is covered.
vec2 scaleCorner(vec2 corners[3], int corner)
{
  vec3 lengths = lengthsOf(corners);
  vec2 incentre = lengths.x * corners[0] + lengths.y * corners[1] + lengths.z * corners[2];
  incentre /= lengths.x + lengths.y + lengths.z;
  float inradius = inradiusOf(corners, lengths);
  // Pixels are drawn only where their centre is covered.
  float scale = (inradius + lineReach + diagonal) / inradius;
  return incentre + scale * (corners[corner] - incentre);
}

// The smallest triangle around the rectangle that covers one line: twice that rectangle.
vec2 coverLine(vec4 ends, int corner)
{
  float margin = lineReach + snap;
  vec2 along = ends.zw - ends.xy;
  float length = length(along);
  // An edge that is seen end on is a dot.
  along = length > 1e-4 ? along / length : vec2(1.0, 0.0);
  vec2 across = vec2(-along.y, along.x);
  vec2 first = ends.xy - margin * (along + across);
  return first + (corner == 1 ? 2.0 * (length + 2.0 * margin) * along : vec2(0.0)) +
         (corner == 2 ? 4.0 * margin * across : vec2(0.0));
}

// Do the triangles along the lineCount lines of a face, so long in all, cover less than the face scaled as a whole?
bool isLarge(vec2 corners[3], float lineLength)
{
  vec3 lengths = lengthsOf(corners);
  float inradius = inradiusOf(corners, lengths);
  float scaled = inradius + lineReach + diagonal;
  float margin = lineReach + snap;
  return inradius > diagonal && 8.0 * margin * (lineLength + 2.0 * margin * float(lineCount)) <
                                    (lengths.x + lengths.y + lengths.z) * scaled * scaled / inradius;
}

// An edge of a face on the screen, as it is handed on.
struct Line
{
  vec4 ends;
  vec2 depths;
  vec2 outwards;
};

// Is an edge a line, and where? line is set when it is.
bool findLine(int face, int edge, vec3 own, vec3 cornersMC[3], vec4 thirdCC, out Line line)
{
  vec4 from;
  vec4 to;
  int kind = kindOf(own, texelFetch(normalTexels, 3 * face + edge).x, eyeMC.xyz - eyeMC.w * cornersMC[edge]);
  if (kind == 0 || !clipEdge(cornersMC[edge], cornersMC[(edge + 1) % 3], from, to))
  {
    return false;
  }
  vec3 fromDC = toScreen(from);
  vec3 toDC = toScreen(to);
  vec2 along = toDC.xy - fromDC.xy;
  float side = kind == 1 ? sign(determinant(mat3(from.xyw, to.xyw, thirdCC.xyw))) : 0.0;
  line = Line(vec4(fromDC.xy, toDC.xy), vec2(fromDC.z, toDC.z), side * vec2(along.y, -along.x));
  return true;
}

// A face's normal, as its raster order orients it: of length 1, or zero without an area. A mesh may be of any size:
// products of lengths as they are would leave single precision.
vec3 normalOf(vec3 cornersMC[3])
{
  vec3 first = cornersMC[1] - cornersMC[0];
  vec3 second = cornersMC[2] - cornersMC[0];
  vec3 largest = max(abs(first), abs(second));
  float size = max(max(largest.x, largest.y), largest.z);
  vec3 normal = size > 0.0 ? cross(first / size, second / size) : vec3(0.0);
  return normal == vec3(0.0) ? normal : normalize(normal);
}

// Hands on those edges of a face that are lines, of a part of it the one that it is drawn for. True: the face is to be
// drawn in three parts.
// edge  of the part
// cut   by the near plane: the face is no triangle on the screen
bool handOnLines(int face, int edge, vec3 cornersMC[3], vec4 cornersCC[3], vec2 corners[3], bool cut)
{
  vec3 own = normalOf(cornersMC);
  Line lines[3];
  bool isLine[3];
  float lineLength = 0.0;
  float longestMC = 0.0;
  lineCount = 0;
  for (int i = 0; i < 3; ++i)
  {
    isLine[i] = findLine(face, i, own, cornersMC, cornersCC[(i + 2) % 3], lines[i]);
    lineCount += isLine[i] ? 1 : 0;
    lineLength += isLine[i] ? distance(lines[i].ends.xy, lines[i].ends.zw) : 0.0;
    longestMC = max(longestMC, distance(cornersMC[i], cornersMC[(i + 1) % 3]));
  }
  bool large = lineCount > 1 && longestMC >= splitFrom && (cut || isLarge(corners, lineLength));
  lineCount = 0;
  for (int i = 0; i < 3; ++i)
  {
    if (isLine[i] && (splits == 0 || i == edge))
    {
      endsDC[lineCount] = lines[i].ends;
      endsDepth[lineCount] = lines[i].depths;
      outwards[lineCount] = lines[i].outwards;
      ++lineCount;
    }
  }
  return large;
}

void main()
{
  int face = gl_VertexID / (splits == 1 ? 9 : 3);
  int vertex = gl_VertexID - face * (splits == 1 ? 9 : 3);
  int corner = vertex % 3;
  vec3 cornersMC[3];
  vec4 cornersCC[3];
  vec2 corners[3];
  bool cut = false;
  for (int i = 0; i < 3; ++i)
  {
    cornersMC[i] = cornerOf(face, i);
    cornersCC[i] = toClip(cornersMC[i]);
    corners[i] = toScreen(cornersCC[i]).xy;
    cut = cut || cornersCC[i].w - nearSign * cornersCC[i].z <= 0.0;
  }
  gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
  bool large = handOnLines(face, vertex / 3, cornersMC, cornersCC, corners, cut);
  if (lineCount == 0 || large != (splits == 1))
  {
    return;
  }
  if (lineCount == 1)
  {
    gl_Position = fromScreen(coverLine(endsDC[0], corner));
    return;
  }
  if (cut)
  {
    // All of the screen, then.
    gl_Position = vec4(corner == 1 ? 3.0 : -1.0, corner == 2 ? 3.0 : -1.0, 0.5, 1.0);
    return;
  }
  if (inradiusOf(corners, lengthsOf(corners)) < 0.5 * diagonal)
  {
    widen(corners);
  }
  gl_Position = fromScreen(scaleCorner(corners, corner));
}
