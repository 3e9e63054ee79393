// precise.glsl - chunk: arithmetic that no compiler may simplify, where the GL has it. To be included first: it asks for an
// extension.
#extension GL_ARB_gpu_shader5 : enable
#if __VERSION__ >= 400 || defined(GL_ARB_gpu_shader5)
#define SHADOW_PRECISE precise
#else
#define SHADOW_PRECISE
#endif
