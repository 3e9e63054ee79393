//VTK::System::Dec
// facing.frag - silhouette camera. Drawn by nodes/drawable/silhouettes/SilhouetteCamera.
// in   facing  uvec2  see facing.vert
flat in uvec2 facing;
out uvec2 texel;

void main()
{
  texel = facing;
}
