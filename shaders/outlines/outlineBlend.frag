//VTK::System::Dec
// outlineBlend.frag - lines over the scene, colours multiplied by opacity.
// unif coverages    sampler2D  see outlineEdge.frag
// unif firstPixel   ivec2      pixel of coverages that belongs to the window's pixel 0, 0
// unif lineColor    vec3
// unif hiddenColor  vec4       and opacity, of what is hidden
// unif smoothLines  int        1: soft, 0: all or nothing
// def  SHADOW_LINE_DEPTH  the depth of visible lines, and no colour:
// unif nearnesses       sampler2D  see outlineCapsule.glsl
// unif windowFromDepth  vec2       window depth = x + y * depth of pass 1
// unif nearSign         float      1: depth rises towards the eye, -1: it falls
uniform sampler2D coverages;
uniform ivec2 firstPixel;
uniform vec3 lineColor;
uniform vec4 hiddenColor;
uniform int smoothLines;
out vec4 color;

#ifdef SHADOW_LINE_DEPTH
uniform sampler2D nearnesses;
uniform vec2 windowFromDepth;
uniform float nearSign;

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy) + firstPixel;
  if (texelFetch(coverages, pixel, 0).z == 0.0)
  {
    discard;
  }
  float nearness = texelFetch(nearnesses, pixel, 0).x;
  gl_FragDepth = windowFromDepth.x + windowFromDepth.y * (nearSign > 0.0 ? nearness : 1.0 - nearness);
  color = vec4(0.0);
}
#else
void main()
{
  vec4 coverage = texelFetch(coverages, ivec2(gl_FragCoord.xy) + firstPixel, 0);
  float visible = smoothLines == 1 ? coverage.x : coverage.z;
  float hidden = (1.0 - visible) * hiddenColor.a * (smoothLines == 1 ? coverage.y : coverage.w);
  if (visible + hidden == 0.0)
  {
    discard;
  }
  color = vec4(visible * lineColor + hidden * hiddenColor.rgb, visible + hidden);
}
#endif
