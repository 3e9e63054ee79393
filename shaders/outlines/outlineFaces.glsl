// outlineFaces.glsl - chunk: the faces of a topology-aware mesh on the screen of outlines. Bound by
// nodes/drawable/surfaces/SEDGeometryDrawable.
// unif positionTexels  samplerBuffer   three texels a vertex, relative to the geometry's origin
// unif cornerTexels    usamplerBuffer  three texels a face: vertices in raster order
// unif clipFromMC      mat4            see shadowClipFromWC()
// unif farFromMC       vec4            dot with a position: 0 or more where VTK's far plane is not passed
// unif screenSize      vec2            pixels
// unif depthFromClip   vec2            window depth = x * z / w + y
// unif nearSign        float           1: depth rises towards the eye, -1: it falls
// unif outside         float           how far beyond the screen lines are followed; 1 is the screen's edge
uniform samplerBuffer positionTexels;
uniform usamplerBuffer cornerTexels;
uniform mat4 clipFromMC;
uniform vec4 farFromMC;
uniform vec2 screenSize;
uniform vec2 depthFromClip;
uniform float nearSign;
uniform float outside;

vec3 cornerOf(int face, int corner)
{
  int first = 3 * int(texelFetch(cornerTexels, 3 * face + corner).x);
  return vec3(texelFetch(positionTexels, first).x, texelFetch(positionTexels, first + 1).x,
              texelFetch(positionTexels, first + 2).x);
}

vec4 toClip(vec3 positionMC)
{
  return clipFromMC * vec4(positionMC, 1.0);
}

// Pixels and window depth.
vec3 toScreen(vec4 position)
{
  vec3 divided = position.xyz / position.w;
  return vec3((0.5 * divided.xy + 0.5) * screenSize, divided.z * depthFromClip.x + depthFromClip.y);
}

// From pixels to a position that lies nowhere in depth.
vec4 fromScreen(vec2 positionDC)
{
  return vec4(2.0 * positionDC / screenSize - 1.0, 0.5, 1.0);
}

// The part of an edge between the near and the far plane and not far beyond the screen. False: there is none. from and
// to become positions in clip space.
// Source: Liang & Barsky 1984, "A New Concept and Method for Line Clipping", in homogeneous coordinates
bool clipEdge(vec3 fromMC, vec3 toMC, out vec4 from, out vec4 to)
{
  from = toClip(fromMC);
  to = toClip(toMC);
  float first = 0.0;
  float last = 1.0;
  for (int plane = 0; plane < 6; ++plane)
  {
    vec4 coefficients = plane == 0   ? vec4(0.0, 0.0, -nearSign, 1.0)
                        : plane == 1 ? vec4(1.0, 0.0, 0.0, outside)
                        : plane == 2 ? vec4(-1.0, 0.0, 0.0, outside)
                        : plane == 3 ? vec4(0.0, 1.0, 0.0, outside)
                                     : vec4(0.0, -1.0, 0.0, outside);
    // The clip space of outlines knows no far plane.
    float atFrom = plane == 5 ? dot(farFromMC, vec4(fromMC, 1.0)) : dot(coefficients, from);
    float atTo = plane == 5 ? dot(farFromMC, vec4(toMC, 1.0)) : dot(coefficients, to);
    if (atFrom < 0.0 && atTo < 0.0)
    {
      return false;
    }
    float crossing = atFrom / (atFrom - atTo);
    first = atFrom < 0.0 ? max(first, crossing) : first;
    last = atTo < 0.0 ? min(last, crossing) : last;
  }
  vec4 step = to - from;
  to = from + last * step;
  from = from + first * step;
  return first <= last;
}
