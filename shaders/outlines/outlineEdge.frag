//VTK::System::Dec
// outlineEdge.frag - pass 2 of outlines: keeps the capsule around an edge, of what is visible of it. Blended by
// maximum, so that of overlapping lines the nearest wins.
// in   endsDC, endsDepth, outwards  see outlineEdge.vert
// out  coverage                     see outlineCapsule.glsl
#include "outlines/outlineCapsule.glsl"
flat in vec4 endsDC;
flat in vec2 endsDepth;
flat in vec2 outwards;
out vec4 coverage;

void main()
{
  coverage = coverCapsule(gl_FragCoord.xy, endsDC, endsDepth, outwards);
  if (coverage == vec4(0.0))
  {
    discard;
  }
}
