//VTK::System::Dec
// volume.frag - volume stage. Drawn by nodes/drawable/ShadowVolumeDrawable. Only the stencil is written.
void main()
{
}
