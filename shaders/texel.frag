//VTK::System::Dec
// texel.frag - a point becomes a texel of up to four integers. Drawn by nodes/drawable/gl/TexelPainter.
// in   texel  uvec4
flat in uvec4 texel;
out uvec4 color;

void main()
{
  color = texel;
}
