//VTK::System::Dec
//VTK::Output::Dec
// outlineFace.frag - pass 2 of outlines: keeps the capsules around those edges of a face that are lines, of what is
// visible of them. Blended by maximum, so that of overlapping lines the nearest wins.
// in   lineCount                    int  edges that are lines
// in   endsDC, endsDepth, outwards  of each of them: see outlineFace.vert
// out  coverage                     see outlineCapsule.glsl; and nearness, with SHADOW_LINE_DEPTH
// Source: Valient, "Hardware Generated Object Silhouettes", section 3.2
#include "outlines/outlineCapsule.glsl"
flat in int lineCount;
flat in vec4 endsDC[3];
flat in vec2 endsDepth[3];
flat in vec2 outwards[3];

void main()
{
  vec4 coverage = vec4(0.0);
  for (int line = 0; line < lineCount; ++line)
  {
    coverage = max(coverage, coverCapsule(gl_FragCoord.xy, endsDC[line], endsDepth[line], outwards[line]));
  }
  if (coverage == vec4(0.0))
  {
    discard;
  }
  gl_FragData[0] = coverage;
#ifdef SHADOW_LINE_DEPTH
  gl_FragData[1] = vec4(nearness);
#endif
}
