//VTK::System::Dec
// kept.frag - bits that are kept of the mask before. Drawn by nodes/drawable/surfaces/ShadowTarget, combined by
// logical AND with what is there.
// unif maskBefore  usampler2D; or usampler2DMS
// unif keptBits    int  bits that are kept where they are
// unif moves       int  how many are kept in another place:
// unif movedFrom   int  the bit's number in the mask before
// unif movedTo     int  the bit's number in the mask
uniform int keptBits;
uniform int moves;
uniform int movedFrom[32];
uniform int movedTo[32];
#ifdef SHADOW_MULTISAMPLE
uniform usampler2DMS maskBefore;
#else
uniform usampler2D maskBefore;
#endif
out uint reached;

void main()
{
#ifdef SHADOW_MULTISAMPLE
  uint before = texelFetch(maskBefore, ivec2(gl_FragCoord.xy), gl_SampleID).r;
#else
  uint before = texelFetch(maskBefore, ivec2(gl_FragCoord.xy), 0).r;
#endif
  reached = before | ~uint(keptBits);
  for (int i = 0; i < moves; ++i)
  {
    if (((before >> uint(movedFrom[i])) & 1u) == 0u)
    {
      reached &= ~(1u << uint(movedTo[i]));
    }
  }
}
