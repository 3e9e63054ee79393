//VTK::System::Dec
// volume.frag - volume stage. Drawn by nodes/drawable/surfaces/ShadowVolumeDrawable and GPUSilhouette; see FaceCounter.
// Only the stencil is written, or the count is added to a colour buffer.
// unif faceWeights   vec2   x what a front face counts, y a back face
// in   multiplicity  float  def SHADOW_MULTIPLICITY: times this
#ifdef SHADOW_COUNT_IN_COLOR
uniform vec2 faceWeights;
out float count;
#endif
#ifdef SHADOW_MULTIPLICITY
flat in float multiplicity;
#endif

void main()
{
#ifdef SHADOW_COUNT_IN_COLOR
  count = gl_FrontFacing ? faceWeights.x : faceWeights.y;
#ifdef SHADOW_MULTIPLICITY
  count *= multiplicity;
#endif
#endif
}
