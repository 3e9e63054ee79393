// outlineVisibility.glsl - chunk: is a point of an edge in front of what pass 1 has drawn?
// unif depths    sampler2D  pass 1
// unif slopes    sampler2D  pass 1, see outlineDepth.frag; left as it was where nothing is drawn
// unif depthScale  float    pixels of pass 1 for one of the screen, in each direction
// unif nearSign  float      1: depth rises towards the eye, -1: it falls
uniform float depthScale;
uniform sampler2D depths;
uniform sampler2D slopes;
uniform float nearSign;

// Rounding of depths, relative.
const float depthError = 1e-6;
// Vertices are snapped to 1/256 of a pixel: the depth of a surface is off by its slope times this.
const float snapError = 0.008;

// Does the surface that a pixel of pass 1 shows lie in front of a point near it, if it goes on as a plane?
bool isBehind(ivec2 pixel, vec3 point)
{
  float depth = texelFetch(depths, pixel, 0).x;
  if (depth == (nearSign > 0.0 ? 0.0 : 1.0))
  {
    return false;
  }
  vec2 slope = depth * texelFetch(slopes, pixel, 0).xy;
  float there = depth + dot(slope, point.xy - (vec2(pixel) + 0.5));
  float tolerance = depthError * abs(point.z) + snapError * (abs(slope.x) + abs(slope.y));
  return nearSign * (there - point.z) > tolerance;
}

// A point of an edge is hidden when all around it is in front of it. Where the surface ends, only what lies beyond
// counts: the surface itself may bulge towards the eye, or come out from under another one close by.
// outwards  the side that counts; zero: all around
bool isVisible(vec3 pointDC, vec2 outwards)
{
  vec3 point = vec3(depthScale * pointDC.xy, pointDC.z);
  ivec2 last = textureSize(depths, 0) - 1;
  ivec2 first = ivec2(floor(point.xy - 0.5));
  bool behind = true;
  for (int i = 0; i < 4 && behind; ++i)
  {
    ivec2 pixel = first + ivec2(i % 2, i / 2);
    if (dot(vec2(pixel) + 0.5 - point.xy, outwards) >= 0.0)
    {
      behind = isBehind(clamp(pixel, ivec2(0), last), point);
    }
  }
  return !behind;
}
