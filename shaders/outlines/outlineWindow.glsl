// outlineWindow.glsl - chunk: is a pixel hidden by what VTK has drawn and pass 1 has not?
// unif windowDepths     sampler2D  window depth, of the view without its margin
// unif windowMargin     int        columns and rows by which the lines' target is wider, on each side
// unif windowFromDepth  vec2       window depth = x + y * depth of pass 1
// unif windowTolerance  float      how much nearer the window's depth has to be
// unif windowReach      float      pixels, by whose change of depth it has to be nearer still; and around a pixel, in
//                                  which surfaces count that are as near: lines on one reach over its rim
#include "outlines/outlineVisibility.glsl"
uniform sampler2D windowDepths;
uniform int windowMargin;
uniform vec2 windowFromDepth;

uniform float windowTolerance;
uniform float windowReach;

// The nearest that pass 1 is in a pixel and a little around it, as window depth; less the change of depth in
// a pixel. Nothing is as far as can be.
float nearestInPixel(ivec2 pixel)
{
  int scale = int(depthScale);
  ivec2 last = textureSize(depths, 0) - 1;
  float farthest = nearSign > 0.0 ? 0.0 : 1.0;
  float nearest = windowFromDepth.x + windowFromDepth.y * farthest;
  int around = max(1, int(ceil((windowReach - 1.0) * depthScale)));
  int stride = around > 1 ? 2 : 1;
  for (int row = -around; row < scale + around; row += stride)
  {
    for (int column = -around; column < scale + around; column += stride)
    {
      ivec2 texel = clamp(scale * pixel + ivec2(column, row), ivec2(0), last);
      float depth = texelFetch(depths, texel, 0).x;
      if (depth != farthest)
      {
        vec2 slope = abs(depth * texelFetch(slopes, texel, 0).xy);
        nearest = min(nearest, windowFromDepth.x + windowFromDepth.y * depth -
                                   abs(windowFromDepth.y) * windowReach * depthScale * (slope.x + slope.y));
      }
    }
  }
  return nearest;
}

// pixelDC  of the lines' target
// depth    of the line, as in pass 1
bool isBehindWindow(vec2 pixelDC, float depth)
{
  ivec2 pixel = ivec2(pixelDC);
  ivec2 ofWindow = pixel - windowMargin;
  if (any(lessThan(ofWindow, ivec2(0))) || any(greaterThanEqual(ofWindow, textureSize(windowDepths, 0))))
  {
    return false;
  }
  float shown = texelFetch(windowDepths, ofWindow, 0).x + windowTolerance;
  return shown < windowFromDepth.x + windowFromDepth.y * depth && shown < nearestInPixel(pixel);
}
