//VTK::System::Dec
// outlineEdge.frag - pass 2 of outlines: keeps the capsule around an edge, of what is visible of it. Blended by
// maximum, so that of overlapping lines the nearest wins.
// in   endsDC, endsDepth, outwards  see outlineEdge.vert
// unif halfWidth  float       of a line, pixels
// out  coverage   vec4        x visible, y hidden lines, both soft over one pixel; z, w the same, all or nothing
// Source: Valient, "Hardware Generated Object Silhouettes", section 3.2
#include "outlineVisibility.glsl"
uniform float halfWidth;
flat in vec4 endsDC;
flat in vec2 endsDepth;
flat in vec2 outwards;
out vec4 coverage;

// A point of the edge, by its distance from the first end.
vec3 pointAt(float place, float length)
{
  float share = length > 0.0 ? place / length : 0.0;
  return vec3(mix(endsDC.xy, endsDC.zw, share), mix(endsDepth.x, endsDepth.y, share));
}

// Soft and hard coverage at a distance from the edge.
vec2 coverageAt(float distance)
{
  return vec2(clamp(halfWidth - distance + 0.5, 0.0, 1.0), distance <= halfWidth ? 1.0 : 0.0);
}

void main()
{
  vec2 pixel = gl_FragCoord.xy;
  float length = distance(endsDC.xy, endsDC.zw);
  vec2 along = length > 0.0 ? (endsDC.zw - endsDC.xy) / length : vec2(0.0);
  float place = clamp(dot(pixel - endsDC.xy, along), 0.0, length);
  vec3 nearest = pointAt(place, length);
  float fromEdge = distance(pixel, nearest.xy);
  float reach = halfWidth + 0.5;
  if (fromEdge >= reach)
  {
    discard;
  }
  vec2 whole = coverageAt(fromEdge);
  if (isVisible(nearest, outwards))
  {
    coverage = vec4(whole.x, 0.0, whole.y, 0.0);
    return;
  }
  // The nearest point is hidden; one a little farther along the edge may not be.
  vec2 visible = vec2(0.0);
  float farthest = sqrt(reach * reach - fromEdge * fromEdge);
  for (float offset = 1.0; offset < farthest + 1.0 && visible.x == 0.0; offset += 1.0)
  {
    float there = min(offset, farthest);
    for (float side = -1.0; side <= 1.0; side += 2.0)
    {
      float other = place + side * there;
      if (other >= 0.0 && other <= length)
      {
        vec3 point = pointAt(other, length);
        vec2 found = coverageAt(distance(pixel, point.xy));
        if (found.x > visible.x && isVisible(point, outwards))
        {
          visible = found;
        }
      }
    }
  }
  coverage = vec4(visible.x, whole.x, visible.y, whole.y);
}
