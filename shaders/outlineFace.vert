//VTK::System::Dec
// outlineFace.vert - pass 2 of outlines, a whole topology-aware mesh. Drawn by nodes/drawable/SEDGeometryDrawable:
// gl_VertexID = 3 * face + corner. A face tells by the normals it stores which of its edges are lines, and is scaled
// on the screen about its incentre until it covers them.
// unif normalTexels     usamplerBuffer  three texels a face: TAMLayout::Shared
// unif eyeMC            vec4            relative to the geometry's origin; w = 0: direction towards it
// unif drawsSilhouette  int             1: edges whose faces face the eye differently
// unif drawsBorder      int             1: edges with the negated own normal
// unif creaseCosine     float           edges whose faces' normals have a smaller cosine; -2: none
// unif lineReach        float           pixels around an edge that may be drawn
// out  edges                        int  bits of those that are lines
// out  endsDC, endsDepth, outwards  of each edge: see outlineEdge.vert
// Source: Valient, "Hardware Generated Object Silhouettes", section 3.1
#include "outlineFaces.glsl"
uniform usamplerBuffer normalTexels;
uniform vec4 eyeMC;
uniform int drawsSilhouette;
uniform int drawsBorder;
uniform float creaseCosine;
uniform float lineReach;
flat out int edges;
flat out vec4 endsDC[3];
flat out vec2 endsDepth[3];
flat out vec2 outwards[3];

// A pixel's diagonal.
const float diagonal = 1.4142136;

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
int kindOf(vec3 own, vec3 other, vec3 toEye)
{
  float cosine = dot(own, other);
  // A border stores the negated own normal, rounded. Two faces folded onto one another cannot be told from it.
  bool border = cosine < -0.999999;
  bool differs = dot(own, toEye) > 0.0 != dot(other, toEye) > 0.0;
  bool line = border ? drawsBorder == 1 : differs && drawsSilhouette == 1;
  return line ? 1 : (!border && cosine < creaseCosine ? 2 : 0);
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

void main()
{
  int face = gl_VertexID / 3;
  vec3 cornersMC[3];
  vec4 cornersCC[3];
  for (int i = 0; i < 3; ++i)
  {
    cornersMC[i] = cornerOf(face, i);
    cornersCC[i] = toClip(cornersMC[i]);
  }
  vec3 own = cross(cornersMC[1] - cornersMC[0], cornersMC[2] - cornersMC[0]);
  own = own == vec3(0.0) ? own : normalize(own);
  edges = 0;
  int lineCount = 0;
  int onlyEdge = 0;
  // A face without area stands in for nothing: its neighbours store the normal beyond it, and have its lines.
  int edgesToAsk = own == vec3(0.0) ? 0 : 3;
  for (int edge = 0; edge < edgesToAsk; ++edge)
  {
    vec3 other = unpackNormal(texelFetch(normalTexels, 3 * face + edge).x);
    int kind = kindOf(own, other, eyeMC.xyz - eyeMC.w * cornersMC[edge]);
    vec4 from;
    vec4 to;
    endsDC[edge] = vec4(0.0);
    endsDepth[edge] = vec2(0.0);
    outwards[edge] = vec2(0.0);
    if (kind != 0 && clipEdge(cornersMC[edge], cornersMC[(edge + 1) % 3], from, to))
    {
      edges |= 1 << edge;
      ++lineCount;
      onlyEdge = edge;
      vec3 fromDC = toScreen(from);
      vec3 toDC = toScreen(to);
      endsDC[edge] = vec4(fromDC.xy, toDC.xy);
      endsDepth[edge] = vec2(fromDC.z, toDC.z);
      vec2 along = toDC.xy - fromDC.xy;
      float side = kind == 1 ? sign(determinant(mat3(from.xyw, to.xyw, cornersCC[(edge + 2) % 3].xyw))) : 0.0;
      outwards[edge] = side * vec2(along.y, -along.x);
    }
  }
  gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
  if (edges == 0)
  {
    return;
  }
  int corner = gl_VertexID - 3 * face;
  vec2 corners[3];
  if (lineCount == 1)
  {
    // One line alone: as narrow a triangle as covers it.
    corners[0] = endsDC[onlyEdge].xy;
    corners[1] = endsDC[onlyEdge].zw;
    corners[2] = corners[0];
  }
  else
  {
    float nearest = 1.0;
    for (int i = 0; i < 3; ++i)
    {
      nearest = min(nearest, cornersCC[i].w - nearSign * cornersCC[i].z);
      corners[i] = toScreen(cornersCC[i]).xy;
    }
    if (nearest <= 0.0)
    {
      // Cut by the near plane the face is no triangle on the screen: all of that, then.
      gl_Position = vec4(corner == 1 ? 3.0 : -1.0, corner == 2 ? 3.0 : -1.0, 0.5, 1.0);
      return;
    }
  }
  if (inradiusOf(corners, lengthsOf(corners)) < 0.5 * diagonal)
  {
    widen(corners);
  }
  gl_Position = fromScreen(scaleCorner(corners, corner));
}
