//VTK::System::Dec
//VTK::Output::Dec
// outlineEdge.frag - pass 2 of outlines: keeps the capsule around an edge, of what is visible of it. Blended by
// maximum, so that of overlapping lines the nearest wins.
// in   endsDC, endsDepth, outwards  see outlineEdge.vert
// out  coverage                     see outlineCapsule.glsl; and nearness, with SHADOW_LINE_DEPTH
#include "outlines/outlineCapsule.glsl"
flat in vec4 endsDC;
flat in vec2 endsDepth;
flat in vec2 outwards;

void main()
{
  vec4 coverage = coverCapsule(gl_FragCoord.xy, endsDC, endsDepth, outwards);
  if (coverage == vec4(0.0))
  {
    discard;
  }
  gl_FragData[0] = coverage;
#ifdef SHADOW_LINE_DEPTH
  gl_FragData[1] = vec4(nearness);
#endif
}
