//VTK::System::Dec
// volume.geom - silhouette, sides and caps of a volume from triangles with adjacency. Drawn by
// nodes/drawable/silhouettes/GeometryShaderSilhouette through AdjacentTriangles, after adjacency.vert.
// Corners 0, 2 and 4 are a triangle as it is oriented. 1, 3 and 5 complete its neighbours across the edges from the corner
// before to the corner after; a border has the corner before in place of a neighbour's.
// Emits at most 24 vertices of 5 components, far below what every GL takes (256 and 1024).
// in   vertexMC, farPosition, beyondNearOfCopies  see adjacency.vert
// unif light            int   Light::index
// unif lightFacingOnly  int   1: Casting::LightFacing
// unif sideBias         vec2  as depthBias in extrusion.glsl, for sides
// def  SHADOW_CAPS            what follows is wanted:
// unif lightCap         int   1: near copies of casting triangles
// unif darkTriangles    int   1: far copies, see Extruder::addDarkTriangles() in nodes/geometry/volumes/ShadowVolume.cxx
// unif darkFan          int   1: a fan over the far ends of the sides
// unif apexMC           vec3  whose far copy is the fan's apex
// out  multiplicity     float see volume.frag
// Source: Zerari & Babahenini 2011, "Shadow Volume in Real-Time Rendering"; open meshes and caps are ours
#include "precise.glsl"
#include "facingSource.glsl"
#include "extrusion.glsl"
layout(triangles_adjacency) in;
#ifdef SHADOW_CAPS
layout(triangle_strip, max_vertices = 24) out;
#else
layout(triangle_strip, max_vertices = 12) out;
#endif
in vec3 vertexMC[];
in vec4 farPosition[];
#ifdef SHADOW_PARALLEL
in vec2 beyondNearOfCopies[];
#endif
uniform int light;
uniform int lightFacingOnly;
uniform vec2 sideBias;
#ifdef SHADOW_CAPS
uniform int lightCap;
uniform int darkTriangles;
uniform int darkFan;
uniform vec3 apexMC;
#endif
flat out float multiplicity;
#ifdef SHADOW_PARALLEL
out float nearDistance;
#endif

// Inputs are indexed by constants only: Mesa 26.1's llvmpipe reads beside inputs that are indexed otherwise, and makes
// that of arrays they are copied into, too.
#define PICK(inputs, i, member)                                                                          \
  (i < 3 ? (i == 0 ? inputs[0] member : (i == 1 ? inputs[1] member : inputs[2] member))                  \
         : (i == 3 ? inputs[3] member : (i == 4 ? inputs[4] member : inputs[5] member)))

vec3 cornerMC(int corner)
{
  return PICK(vertexMC, corner, .xyz);
}

bool comesBefore(vec3 a, vec3 b)
{
  return a.x != b.x ? a.x < b.x : (a.y != b.y ? a.y < b.y : a.z < b.z);
}

// Corners sorted as SEDGeometry::getTriangles() has them: whoever asks about a triangle evaluates it the same way.
// winding: -1 where they ran against that order, else 1
ivec3 toRasterOrder(ivec3 corners, out float winding)
{
  winding = 1.0;
  if (comesBefore(cornerMC(corners.y), cornerMC(corners.x)))
  {
    corners = corners.yxz;
    winding = -winding;
  }
  if (comesBefore(cornerMC(corners.z), cornerMC(corners.y)))
  {
    corners = corners.xzy;
    winding = -winding;
  }
  if (comesBefore(cornerMC(corners.y), cornerMC(corners.x)))
  {
    corners = corners.yxz;
    winding = -winding;
  }
  return corners;
}

// How a triangle casts, see castingSign(). corners: as it is oriented
int castingOf(ivec3 corners)
{
  float winding;
  corners = toRasterOrder(corners, winding);
  uvec2 bits = facingBitsOf(cornerMC(corners.x), cornerMC(corners.y), cornerMC(corners.z), winding);
  return castingSign(bits, light, lightFacingOnly == 1);
}

// A vertex of the volume, in clip space.
struct Copy
{
  vec4 position;
  float nearDistance; // parallel views only, see beyondNear()
};

Copy nearCopy(int corner)
{
#ifdef SHADOW_PARALLEL
  return Copy(PICK(gl_in, corner, .gl_Position), PICK(beyondNearOfCopies, corner, .x));
#else
  return Copy(PICK(gl_in, corner, .gl_Position), 0.0);
#endif
}

Copy farCopy(int corner)
{
#ifdef SHADOW_PARALLEL
  return Copy(PICK(farPosition, corner, .xyzw), PICK(beyondNearOfCopies, corner, .y));
#else
  return Copy(PICK(farPosition, corner, .xyzw), 0.0);
#endif
}

void emit(Copy copy, float times)
{
  gl_Position = copy.position;
#ifdef SHADOW_PARALLEL
  nearDistance = copy.nearDistance;
#endif
  multiplicity = times;
  EmitVertex();
}

void emitSide(Copy copy, float times)
{
  copy.position.z = copy.position.z * sideBias.x + copy.position.w * sideBias.y;
  emit(copy, times);
}

#ifdef SHADOW_CAPS
Copy farApex()
{
  vec4 positionMC = copyOf(apexMC, true);
#ifdef SHADOW_PARALLEL
  return Copy(toClip(positionMC), beyondNear(positionMC));
#else
  return Copy(toClip(positionMC), 0.0);
#endif
}
#endif

// The side that hangs from an edge of the silhouette. Of the edge's two triangles the one that casts as it is oriented draws
// it, or else the one that casts at all: it is drawn once.
// from, to  the edge as the triangle is oriented
// own       how the triangle casts, not 0; other: how its neighbour does
void drawSide(int from, int to, int own, int other)
{
  if (own == other || other > 0)
  {
    return;
  }
  int first = own > 0 ? from : to;
  int second = own > 0 ? to : from;
  float times = abs(float(own - other));
  emitSide(nearCopy(first), times);
  emitSide(farCopy(first), times);
  emitSide(nearCopy(second), times);
  emitSide(farCopy(second), times);
  EndPrimitive();
#ifdef SHADOW_CAPS
  if (darkFan == 1)
  {
    emitSide(farApex(), times);
    emitSide(farCopy(second), times);
    emitSide(farCopy(first), times);
    EndPrimitive();
  }
#endif
}

#ifdef SHADOW_CAPS
// casts  how the triangle does
void drawCaps(int casts)
{
  float winding;
  ivec3 corners = toRasterOrder(ivec3(0, 2, 4), winding);
  if (lightCap == 1 && casts != 0)
  {
    float times = winding * float(casts);
    emit(nearCopy(corners.x), times);
    emit(nearCopy(corners.y), times);
    emit(nearCopy(corners.z), times);
    EndPrimitive();
  }
  // The averted triangles of a closed mesh have the border of the others, the other way round.
  int turned = lightFacingOnly == 1 ? 1 - casts : -casts;
  if (darkTriangles == 1 && turned != 0)
  {
    // The middle corner first: rasterisers derive depth from the two edges at the first corner, and in the products of short
    // edges less is lost; a sliver would else be without depth. No surface lies there that would ask for raster order.
    float times = winding * float(turned);
    emit(farCopy(corners.y), times);
    emit(farCopy(corners.z), times);
    emit(farCopy(corners.x), times);
    EndPrimitive();
  }
}
#endif

void main()
{
  int casts = 0;
  // The triangle, then its neighbours if it casts; all by the same code, so that they agree where nothing is precise.
  for (int i = 0; i < 4 && (i == 0 || casts != 0); ++i)
  {
    int from = max(2 * i - 2, 0);
    int to = 2 * i % 6;
    bool border = i > 0 && cornerMC(from + 1) == cornerMC(from);
    int sign = border ? 0 : castingOf(i == 0 ? ivec3(0, 2, 4) : ivec3(to, from, from + 1));
    if (i == 0)
    {
      casts = sign;
    }
    else
    {
      drawSide(from, to, casts, sign);
    }
  }
#ifdef SHADOW_CAPS
  drawCaps(casts);
#endif
}
