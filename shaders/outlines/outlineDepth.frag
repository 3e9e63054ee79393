//VTK::System::Dec
// outlineDepth.frag - pass 1 of outlines. Drawn by nodes/drawable/surfaces/SEDGeometryDrawable.
// Beside the depth its slope, by which pass 2 knows how deep the surface is between the centres of pixels.
// out  slope  vec2  depth a pixel, to the right and up, relative to the depth: half floats hold it
out vec2 slope;

void main()
{
  slope = clamp(vec2(dFdx(gl_FragCoord.z), dFdy(gl_FragCoord.z)) / gl_FragCoord.z, -60000.0, 60000.0);
}
