//VTK::System::Dec
// mask.frag - mask stage. Drawn by nodes/drawable/StencilTarget where the stencil count is not zero, combined by logical AND with what is there.
// unif lightBit  int  bit of the light in the mask
uniform int lightBit;
out uint reached;

void main()
{
  reached = ~(1u << uint(lightBit));
}
