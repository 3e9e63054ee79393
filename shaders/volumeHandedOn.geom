//VTK::System::Dec
// volumeHandedOn.geom - volumes from the CPU beside those of volume.geom: hands on what extrude.vert gives, see surface.geom.
layout(triangles) in;
layout(triangle_strip, max_vertices = 3) out;
#ifdef SHADOW_PARALLEL
in float nearDistanceOfCorner[];
out float nearDistance;
#endif

// Constant indices, see volume.geom.
void handOn(vec4 position, float ofNear)
{
  gl_Position = position;
#ifdef SHADOW_PARALLEL
  nearDistance = ofNear;
#endif
  EmitVertex();
}

void main()
{
#ifdef SHADOW_PARALLEL
  handOn(gl_in[0].gl_Position, nearDistanceOfCorner[0]);
  handOn(gl_in[1].gl_Position, nearDistanceOfCorner[1]);
  handOn(gl_in[2].gl_Position, nearDistanceOfCorner[2]);
#else
  handOn(gl_in[0].gl_Position, 0.0);
  handOn(gl_in[1].gl_Position, 0.0);
  handOn(gl_in[2].gl_Position, 0.0);
#endif
  EndPrimitive();
}
