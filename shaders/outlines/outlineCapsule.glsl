// outlineCapsule.glsl - chunk: what of a pixel the line of one edge covers.
// unif halfWidth  float  of a line, pixels
// Source: Valient, "Hardware Generated Object Silhouettes", section 3.2
// def  SHADOW_WINDOW_DEPTH  what the window shows in front of a line hides it, too
// def  SHADOW_LINE_DEPTH    the depth of visible lines is wanted
#include "outlines/outlineVisibility.glsl"
#ifdef SHADOW_WINDOW_DEPTH
#include "outlines/outlineWindow.glsl"
#endif
uniform float halfWidth;
#ifdef SHADOW_LINE_DEPTH
// Of the line that coverCapsule() has found visible: rises towards the eye, 0 at the farthest.
float nearness = 0.0;

void keepDepth(float depth)
{
  nearness = max(nearness, nearSign > 0.0 ? depth : 1.0 - depth);
}
#else
void keepDepth(float depth)
{
}
#endif

// A point of an edge, by its distance from the first end.
vec3 pointAt(vec4 endsDC, vec2 endsDepth, float place, float length)
{
  float share = length > 0.0 ? place / length : 0.0;
  return vec3(mix(endsDC.xy, endsDC.zw, share), mix(endsDepth.x, endsDepth.y, share));
}

// Soft and hard coverage at a distance from the edge.
vec2 coverageAt(float distance)
{
  return vec2(clamp(halfWidth - distance + 0.5, 0.0, 1.0), distance <= halfWidth ? 1.0 : 0.0);
}

// x visible, y hidden lines, both soft over one pixel; z, w the same, all or nothing.
// endsDC, endsDepth, outwards  see outlineEdge.vert
vec4 coverCapsule(vec2 pixel, vec4 endsDC, vec2 endsDepth, vec2 outwards)
{
  float length = distance(endsDC.xy, endsDC.zw);
  vec2 along = length > 0.0 ? (endsDC.zw - endsDC.xy) / length : vec2(0.0);
  float place = clamp(dot(pixel - endsDC.xy, along), 0.0, length);
  vec3 nearest = pointAt(endsDC, endsDepth, place, length);
  float fromEdge = distance(pixel, nearest.xy);
  float reach = halfWidth + 0.5;
  if (fromEdge >= reach)
  {
    return vec4(0.0);
  }
  vec2 whole = coverageAt(fromEdge);
#ifdef SHADOW_WINDOW_DEPTH
  if (isBehindWindow(pixel, nearest.z))
  {
    return vec4(0.0, whole.x, 0.0, whole.y);
  }
#endif
  if (isVisible(nearest, outwards))
  {
    keepDepth(nearest.z);
    return vec4(whole.x, 0.0, whole.y, 0.0);
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
        vec3 point = pointAt(endsDC, endsDepth, other, length);
        vec2 found = coverageAt(distance(pixel, point.xy));
        if (found.x > visible.x && isVisible(point, outwards))
        {
          visible = found;
          keepDepth(point.z);
        }
      }
    }
  }
  return vec4(visible.x, whole.x, visible.y, whole.y);
}
