// batchedObject.glsl - chunk: what extrusion.glsl takes as uniforms, where many meshes are drawn together.
// in   object        uint           place of the vertex's mesh
// unif objectTexels  samplerBuffer  a mesh: four columns of clipFromMC, then nearFromMC
// unif lightTexels   samplerBuffer  a mesh: lightMC, then lightLowMC and rayLength, then farPlaneMC; volumes only
in uint object;
uniform samplerBuffer objectTexels;
mat4 clipFromMC;
vec4 lightMC;
vec3 lightLowMC;
float rayLength;
vec4 farPlaneMC;
#ifdef SHADOW_PARALLEL
vec4 nearFromMC;
#endif
#ifndef SHADOW_PREPASS
uniform samplerBuffer lightTexels;
#endif

// To be called before anything else.
void readObject()
{
  int first = 5 * int(object);
  clipFromMC = mat4(texelFetch(objectTexels, first), texelFetch(objectTexels, first + 1),
                    texelFetch(objectTexels, first + 2), texelFetch(objectTexels, first + 3));
#ifdef SHADOW_PARALLEL
  nearFromMC = texelFetch(objectTexels, first + 4);
#endif
#ifndef SHADOW_PREPASS
  int firstOfLight = 3 * int(object);
  lightMC = texelFetch(lightTexels, firstOfLight);
  vec4 lowAndLength = texelFetch(lightTexels, firstOfLight + 1);
  lightLowMC = lowAndLength.xyz;
  rayLength = lowAndLength.w;
  farPlaneMC = texelFetch(lightTexels, firstOfLight + 2);
#endif
}
