//VTK::System::Dec
// mask.frag - mask stage. Drawn by nodes/drawable/surfaces/ShadowTarget, combined by logical AND with what is there.
// The stencil test lets pass where the count is not zero, or the shader looks at the count itself.
// unif maskBit   int        bit of the light in the mask
// unif counts    sampler2D  counts of faces; or sampler2DMS
uniform int maskBit;
#ifdef SHADOW_MULTISAMPLE
uniform sampler2DMS counts;
#elif defined(SHADOW_COUNT_IN_COLOR)
uniform sampler2D counts;
#endif
out uint reached;

void main()
{
#ifdef SHADOW_MULTISAMPLE
  float count = texelFetch(counts, ivec2(gl_FragCoord.xy), gl_SampleID).r;
#elif defined(SHADOW_COUNT_IN_COLOR)
  float count = texelFetch(counts, ivec2(gl_FragCoord.xy), 0).r;
#endif
#ifdef SHADOW_COUNT_IN_COLOR
  if (count == 0.0)
  {
    discard;
  }
#endif
  reached = ~(1u << uint(maskBit));
}
