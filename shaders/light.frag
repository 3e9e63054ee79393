//VTK::System::Dec
// light.frag - Additive: what a light adds to the picture. Drawn by nodes/drawable/surfaces/LightTarget.
// unif light        sampler2D, or sampler2DMS
// unif sampleIndex  int  the sample that is added, with several a pixel
#ifdef SHADOW_MULTISAMPLE
uniform sampler2DMS light;
uniform int sampleIndex;
#else
uniform sampler2D light;
const int sampleIndex = 0;
#endif
out vec4 color;

void main()
{
  color = texelFetch(light, ivec2(gl_FragCoord.xy), sampleIndex);
}
