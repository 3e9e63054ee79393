//VTK::System::Dec
// resolve.frag - mask read-back with several samples. Drawn by nodes/drawable/surfaces/ShadowTarget.
// unif shadowMask  usampler2DMS
// unif maskBit     int  bit of the light in the mask
// unif samples     int  samples a pixel
uniform usampler2DMS shadowMask;
uniform int maskBit;
uniform int samples;
out float share;

void main()
{
  uint reached = 0u;
  for (int i = 0; i < samples; ++i)
  {
    reached += (texelFetch(shadowMask, ivec2(gl_FragCoord.xy), i).r >> uint(maskBit)) & 1u;
  }
  share = float(reached) / float(samples);
}
