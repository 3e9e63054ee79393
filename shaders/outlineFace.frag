//VTK::System::Dec
// outlineFace.frag - pass 2 of outlines: keeps the capsules around those edges of a face that are lines, of what is
// visible of them. Blended by maximum, so that of overlapping lines the nearest wins.
// in   endsDC, endsDepth, outwards  of its three edges: see outlineFace.vert
// in   edges                        int  bits of those that are lines
// out  coverage                     see outlineCapsule.glsl
// Source: Valient, "Hardware Generated Object Silhouettes", section 3.2
#include "outlineCapsule.glsl"
flat in int edges;
flat in vec4 endsDC[3];
flat in vec2 endsDepth[3];
flat in vec2 outwards[3];
out vec4 coverage;

void main()
{
  coverage = vec4(0.0);
  for (int edge = 0; edge < 3; ++edge)
  {
    if ((edges >> edge & 1) == 1)
    {
      coverage = max(coverage, coverCapsule(gl_FragCoord.xy, endsDC[edge], endsDepth[edge], outwards[edge]));
    }
  }
  if (coverage == vec4(0.0))
  {
    discard;
  }
}
