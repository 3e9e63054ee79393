//VTK::System::Dec
// back.frag - counts the pixels where a mesh shows its back. Drawn by nodes/drawable/surfaces/ShadowTarget into an occlusion
// query.
// unif shadowMask  usampler2D  of the pre-pass
// unif backBit     int         bit that the pre-pass has cleared where it drew a back of the mesh
uniform usampler2D shadowMask;
uniform int backBit;
out float count;

void main()
{
  if ((texelFetch(shadowMask, ivec2(gl_FragCoord.xy), 0).r & uint(backBit)) != 0u)
  {
    discard;
  }
  count = 0.0;
}
