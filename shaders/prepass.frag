//VTK::System::Dec
// prepass.frag - pre-pass. Drawn by nodes/drawable/surfaces/SEDGeometryDrawable.
// Starts the shadow mask: a bit stays set where the visible side of the triangle faces the light.
// in   sideBits  uvec2  of the triangle: x raster-front, y raster-back side; bit i: that side faces light i
flat in uvec2 sideBits;
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
  reached = gl_FrontFacing ? sideBits.x : sideBits.y;
}
