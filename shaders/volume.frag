//VTK::System::Dec
// volume.frag - volume stage. Drawn by nodes/drawable/ShadowVolumeDrawable; see FaceCounter.
// Only the stencil is written, or the count is added to a colour buffer.
// unif faceWeights  vec2  x what a front face counts, y a back face
#ifdef SHADOW_COUNT_IN_COLOR
uniform vec2 faceWeights;
out float count;
#endif

void main()
{
#ifdef SHADOW_COUNT_IN_COLOR
  count = gl_FrontFacing ? faceWeights.x : faceWeights.y;
#endif
}
