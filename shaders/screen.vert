//VTK::System::Dec
// screen.vert - one triangle over the whole viewport, made from the vertex number. Drawn by nodes/drawable/surfaces/ShadowTarget.
// unif farDepth  float  depth in clip space
uniform float farDepth;

void main()
{
  vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
  gl_Position = vec4(corner, farDepth, 1.0);
}
