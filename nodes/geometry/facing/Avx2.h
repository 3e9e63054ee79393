#pragma once

// Functions for x86 with AVX2, in a build for any x86: see InstructionSet.
#if defined(__GNUC__) && defined(__x86_64__)
#define SHADOW_HAS_AVX2
#define SHADOW_TARGET_AVX2 __attribute__((target("avx2")))
#define SHADOW_INLINE_AVX2 __attribute__((target("avx2"), always_inline)) inline
#include <immintrin.h>
#endif
