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

void main()
{
  for (int i = 0; i < 3; ++i)
  {
    gl_Position = gl_in[i].gl_Position;
    sideBits = sideBitsOfCorner[2];
#ifdef SHADOW_PARALLEL
    nearDistance = nearDistanceOfCorner[i];
#endif
    EmitVertex();
  }
  EndPrimitive();
}
