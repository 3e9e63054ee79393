//VTK::System::Dec
// outlineBlend.frag - lines over the scene, colours multiplied by opacity.
// unif coverages    sampler2D  see outlineEdge.frag
// unif firstPixel   ivec2      pixel of coverages that belongs to the window's pixel 0, 0
// unif lineColor    vec3
// unif hiddenColor  vec4       and opacity, of what is hidden
// unif smoothLines  int        1: soft, 0: all or nothing
uniform sampler2D coverages;
uniform ivec2 firstPixel;
uniform vec3 lineColor;
uniform vec4 hiddenColor;
uniform int smoothLines;
out vec4 color;

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
