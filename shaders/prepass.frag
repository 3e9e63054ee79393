//VTK::System::Dec
// prepass.frag - pre-pass. Drawn by nodes/drawable/SEDGeometryDrawable.
// Starts the shadow mask: a bit stays set where the visible side of the triangle faces the light.
// unif reachableBits  usamplerBuffer  a texel a triangle: r raster-front, g raster-back side; bit i = light i
uniform usamplerBuffer reachableBits;
#ifdef SHADOW_PARALLEL
in float nearDistance;
#endif
out uint reached;

void main()
{
#ifdef SHADOW_PARALLEL
  // Depth clamp is on, so that volumes are not cut; what VTK would clip is taken away here.
  if (nearDistance < 0.0)
  {
    discard;
  }
#endif
  uvec2 bits = texelFetch(reachableBits, gl_PrimitiveID).rg;
  reached = gl_FrontFacing ? bits.x : bits.y;
}
