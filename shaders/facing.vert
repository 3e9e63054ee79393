//VTK::System::Dec
// facing.vert - silhouette camera. Drawn by nodes/drawable/silhouettes/SilhouetteCamera through TriangleDrawable: each triangle is
// a point that covers the triangle's texel of the layer that is drawn.
// Here, not in facing.frag: a software rasteriser shades whole blocks of pixels around a point.
// in   cornerAHigh .. cornerCLow  vec3  corners in scene space, each as the sum of two
// in   winding        float  1: the oriented triangle runs as its corners do; -1: against them
// unif lightCount     int
// unif lightPosition  vec4[]  high part, and w; see SceneLight
// unif lightLow       vec3[]  low part
// unif lightBit       int[]   the light's bit in the texel
// unif layerSize      ivec2   width and height of a layer of the texture
// out  facing         uvec2   x: bits of the lights in front of the oriented triangle, y: behind it
// Source: Shi 2006, chapter 3.3 (improved method)
#include "precise.glsl"
#include "facing.glsl"
#include "texelArray.glsl"
in vec3 cornerAHigh;
in vec3 cornerALow;
in vec3 cornerBHigh;
in vec3 cornerBLow;
in vec3 cornerCHigh;
in vec3 cornerCLow;
in float winding;
uniform int lightCount;
uniform vec4 lightPosition[32];
uniform vec3 lightLow[32];
uniform int lightBit[32];
uniform ivec2 layerSize;
flat out uvec2 facing;

void main()
{
  FacingPlane plane = makeFacingPlane(SplitVector(cornerAHigh, cornerALow), SplitVector(cornerBHigh, cornerBLow),
                                      SplitVector(cornerCHigh, cornerCLow));
  uvec2 bits = uvec2(0u);
  for (int i = 0; i < lightCount; ++i)
  {
    float side = winding * facingOf(plane, SplitVector(lightPosition[i].xyz, lightLow[i]), lightPosition[i].w);
    uint bit = 1u << uint(lightBit[i]);
    bits |= uvec2(side > 0.0 ? bit : 0u, side < 0.0 ? bit : 0u);
  }
  facing = bits;
  vec2 centre = vec2(texelPlace(gl_VertexID, layerSize).xy) + 0.5;
  gl_Position = vec4(2.0 * centre / vec2(layerSize) - 1.0, 0.0, 1.0);
  gl_PointSize = 1.0;
}
