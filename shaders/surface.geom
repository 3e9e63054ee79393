//VTK::System::Dec
// surface.geom - pre-pass of a method that draws its volumes through a geometry shader: hands on what surface.vert gives.
// A software GL divides by w elsewhere after a geometry shader, and rounds differently: light caps get bit for bit the depth
// of their surfaces only where both or neither pass through one.
// in   sideBitsOfCorner      uvec2  of the last corner: see prepass.frag
// in   nearDistanceOfCorner  float  parallel views only
layout(triangles) in;
layout(triangle_strip, max_vertices = 3) out;
flat in uvec2 sideBitsOfCorner[];
flat out uvec2 sideBits;
#ifdef SHADOW_PARALLEL
in float nearDistanceOfCorner[];
out float nearDistance;
#endif

// Constant indices, see volume.geom.
void handOn(vec4 position, float ofNear)
{
  gl_Position = position;
  sideBits = sideBitsOfCorner[2];
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
