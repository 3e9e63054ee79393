//VTK::System::Dec
// volume.frag - volume stage. Drawn by nodes/drawable/surfaces/ShadowVolumeDrawable and GPUSilhouette; see FaceCounter.
// Only the stencil is written, or the count is added to a colour buffer.
// unif faceWeights   vec2   x what a front face counts, y a back face
// in   multiplicity  float  def SHADOW_MULTIPLICITY: times this
// in   nearDistance  float  def SHADOW_PARALLEL: in front of the near plane, where nothing is counted, it is negative
#ifdef SHADOW_COUNT_IN_COLOR
uniform vec2 faceWeights;
out float count;
#endif
#ifdef SHADOW_MULTIPLICITY
flat in float multiplicity;
#endif
#ifdef SHADOW_PARALLEL
in float nearDistance;
#endif

void main()
{
#ifdef SHADOW_PARALLEL
  // Not by a clip distance: an NVIDIA H200 (580.159) lost triangles that have a corner with negative w by that.
  if (nearDistance < 0.0)
  {
    discard;
  }
#endif
#ifdef SHADOW_COUNT_IN_COLOR
  count = gl_FrontFacing ? faceWeights.x : faceWeights.y;
#ifdef SHADOW_MULTIPLICITY
  count *= multiplicity;
#endif
#endif
}
