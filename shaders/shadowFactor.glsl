// shadowFactor.glsl - put in front of main() of VTK's own fragment shaders by plugin/passes/LightingHook.
// unif shadowMask      usampler2D[MS]  bit i set: light i reaches the surface
// unif shadowDepth     sampler2D[MS]   depth of that surface
// unif shadowOrigin    ivec2           lower left pixel of the viewport
// unif shadowStrength  float[]         a light: ShadowIntensity * ShadowAttenuation, 0 for one without shadows
// unif shadowPass      int             -1 all lights, -2 none (ambient pass), else only this light (lighting pass)
// unif shadowRange     vec4            x, y: stored depth d to distance (perspective x / d, parallel x + y d);
//                                      z, w: parallel gl_FragCoord.z to distance z + w z; y = w = 0: perspective
// unif shadowReversed  int             1: d is the stored depth, 0: 1 - stored depth
// unif shadowSamplePlace  vec2[]       a sample: its place in the pixel, 0 to 1
// unif shadowEverySample  int          -1: all samples count; 0: those that the fragment covers, as far as is known
// def  SHADOW_SAMPLES  samples a pixel
// def  SHADOW_COVERAGE 1: the shader knows which samples the fragment covers
// def  SHADOW_MATCH    1: the fragment may not be the surface of the mask, compare depths
//
// Choices are made by the preprocessor where they can be: a software rasteriser runs both sides of a branch.
#if SHADOW_SAMPLES > 1
uniform usampler2DMS shadowMask;
uniform sampler2DMS shadowDepth;
#else
uniform usampler2D shadowMask;
uniform sampler2D shadowDepth;
#endif
uniform ivec2 shadowOrigin;
uniform float shadowStrength[32];
uniform int shadowPass;
uniform vec4 shadowRange;
uniform int shadowReversed;
uniform vec2 shadowSamplePlace[SHADOW_SAMPLES];
#if SHADOW_COVERAGE == 1
uniform int shadowEverySample;
#endif

#if SHADOW_SAMPLES == 1 && SHADOW_MATCH == 0
// The mask's word for the fragment; read once, at the start of main().
uint shadowWord;

void readShadowMask()
{
  shadowWord = texelFetch(shadowMask, ivec2(gl_FragCoord.xy) - shadowOrigin, 0).r;
}

// Share of the light that reaches the fragment: 1 all, 0 none.
float shadowReached(int light)
{
  return float((shadowWord >> uint(light)) & 1u);
}
#else
void readShadowMask()
{
}

// What changes evenly over the screen on a plane: 1 / distance in a perspective, else distance. Of a depth of the mask.
float shadowEvenDepth(ivec2 pixel, int sampleIndex)
{
  float stored = texelFetch(shadowDepth, pixel, sampleIndex).r;
  float depth = shadowReversed == 1 ? stored : 1.0 - stored;
  return shadowRange.y == 0.0 ? depth / shadowRange.x : shadowRange.x + shadowRange.y * depth;
}

// The samples of the mask that belong to the fragment count: those that it covers and that are in its plane; if there
// are none, all in its plane; at last all that are about as deep.
float shadowReached(int light)
{
  ivec2 pixel = ivec2(gl_FragCoord.xy) - shadowOrigin;
  bool perspective = shadowRange.y == 0.0;
  float here = perspective ? gl_FragCoord.w : shadowRange.z + shadowRange.w * gl_FragCoord.z;
  vec2 slope = vec2(dFdx(here), dFdy(here));
  float inPixel = abs(slope.x) + abs(slope.y);
  // Corners are snapped to 1/256 of a pixel, by VTK and by us, and VTK rounds positions on its own.
  float planeTolerance = 0.02 * inPixel + 1e-5 * abs(here);
  float nearTolerance = 2.0 * inPixel + 1e-4 * abs(here);
  // Samples, and of these those that are reached.
  vec2 all = vec2(0.0);
  vec2 near = vec2(0.0);
  vec2 inPlane = vec2(0.0);
  vec2 covered = vec2(0.0);
  for (int i = 0; i < SHADOW_SAMPLES; ++i)
  {
    vec2 counted = vec2(1.0, float((texelFetch(shadowMask, pixel, i).r >> uint(light)) & 1u));
    float there = shadowEvenDepth(pixel, i);
    all += counted;
    near += abs(there - here) <= nearTolerance ? counted : vec2(0.0);
    float ofPlane = here + dot(slope, shadowSamplePlace[i] - 0.5);
    counted = abs(there - ofPlane) <= planeTolerance ? counted : vec2(0.0);
    inPlane += counted;
#if SHADOW_COVERAGE == 1
    covered += float(((gl_SampleMaskIn[0] | shadowEverySample) >> i) & 1) * counted;
#endif
  }
  vec2 own = covered.x > 0.0 ? covered : (inPlane.x > 0.0 ? inPlane : near);
  if (own.x > 0.0)
  {
    return own.y / own.x;
  }
#if SHADOW_MATCH == 1
  return 1.0;
#else
  return all.y / all.x;
#endif
}
#endif

// What the diffuse and specular part of a light is multiplied with.
float shadowFactor(int light)
{
  float strength = shadowStrength[light];
  return strength == 0.0 ? 1.0 : 1.0 - strength * (1.0 - shadowReached(light));
}

// The same in an additive pass, where the other lights have their own.
float shadowFactorOfPass(int light)
{
  return shadowPass == -1 || shadowPass == light ? shadowFactor(light) : 0.0;
}
