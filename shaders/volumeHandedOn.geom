//VTK::System::Dec
// volumeHandedOn.geom - volumes from the CPU beside those of volume.geom: hands on what extrude.vert gives, see surface.geom.
layout(triangles) in;
layout(triangle_strip, max_vertices = 3) out;
#ifdef SHADOW_PARALLEL
in float nearDistanceOfCorner[];
out float nearDistance;
#endif

void main()
{
  for (int i = 0; i < 3; ++i)
  {
    gl_Position = gl_in[i].gl_Position;
#ifdef SHADOW_PARALLEL
    nearDistance = nearDistanceOfCorner[i];
#endif
    EmitVertex();
  }
  EndPrimitive();
}
