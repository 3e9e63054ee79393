// facing.glsl - chunk: on which side of a triangle is a light? The one function that says so on the GPU.
// The counterpart of nodes/geometry/facing/LightFacing, in scene space (nodes/scene/SceneFrame).
//
// Every number is the sum of two floats, 48 bits in all, so that nothing is lost but what double precision would
// lose nearly as well. Exact steps need what GLSL calls precise: there from GLSL 4.00 or with ARB_gpu_shader5. A GL
// without may simplify them; the sign is then right as far as single precision goes (measured: for lights farther than
// 5e-8 of their distance from the plane; with exact steps 7e-15), and still the same for all who read it in one place.
// Stages that evaluate the same triangle must hand over its corners in the same order: they then agree bit for bit.
// Stages include precise.glsl before it.
// Source: Dekker 1971, "A Floating-Point Technique for Extending the Available Precision" (products);
//         Knuth, "The Art of Computer Programming", volume 2, 4.2.2 (sums)
struct SplitVector
{
  vec3 high;
  vec3 low;
};

// What a triangle needs for any number of lights.
struct FacingPlane
{
  SplitVector corner; // the first
  SplitVector normal; // cross product of the edges from there, neither oriented nor normalised
  SplitVector toSecond; // those edges
  SplitVector toThird;
};

// a + b, exactly.
SplitVector exactSum(vec3 a, vec3 b)
{
  SHADOW_PRECISE vec3 sum = a + b;
  SHADOW_PRECISE vec3 added = sum - a;
  SHADOW_PRECISE vec3 error = (a - (sum - added)) + (b - added);
  return SplitVector(sum, error);
}

// The first 12 of a float's 24 bits.
vec3 firstHalf(vec3 a)
{
  SHADOW_PRECISE vec3 scaled = 4097.0 * a;
  SHADOW_PRECISE vec3 rest = scaled - a;
  SHADOW_PRECISE vec3 result = scaled - rest;
  return result;
}

// a * b, exactly.
SplitVector exactProduct(vec3 a, vec3 b)
{
  vec3 a1 = firstHalf(a);
  vec3 b1 = firstHalf(b);
  SHADOW_PRECISE vec3 a2 = a - a1;
  SHADOW_PRECISE vec3 b2 = b - b1;
  SHADOW_PRECISE vec3 product = a * b;
  SHADOW_PRECISE vec3 error = ((a1 * b1 - product) + a1 * b2 + a2 * b1) + a2 * b2;
  return SplitVector(product, error);
}

SplitVector add(SplitVector a, SplitVector b)
{
  SplitVector sum = exactSum(a.high, b.high);
  SplitVector rest = exactSum(a.low, b.low);
  SHADOW_PRECISE vec3 low = sum.low + rest.high;
  sum = exactSum(sum.high, low);
  SHADOW_PRECISE vec3 lowest = sum.low + rest.low;
  return exactSum(sum.high, lowest);
}

SplitVector negate(SplitVector a)
{
  return SplitVector(-a.high, -a.low);
}

SplitVector multiply(SplitVector a, SplitVector b)
{
  SplitVector product = exactProduct(a.high, b.high);
  SHADOW_PRECISE vec3 low = product.low + (a.high * b.low + a.low * b.high);
  return exactSum(product.high, low);
}

SplitVector turnOnce(SplitVector a)
{
  return SplitVector(a.high.yzx, a.low.yzx);
}

SplitVector turnTwice(SplitVector a)
{
  return SplitVector(a.high.zxy, a.low.zxy);
}

FacingPlane makeFacingPlane(SplitVector a, SplitVector b, SplitVector c)
{
  SplitVector u = add(b, negate(a));
  SplitVector v = add(c, negate(a));
  SplitVector normal = add(multiply(turnOnce(u), turnTwice(v)), negate(multiply(turnTwice(u), turnOnce(v))));
  return FacingPlane(a, normal, u, v);
}

float distanceBetween(SplitVector a, SplitVector b)
{
  vec3 apart = abs(add(a, negate(b)).high);
  return max(max(apart.x, apart.y), apart.z);
}

// 1: the light sees the corners counter-clockwise; -1: clockwise; 0: it is in their plane, or a point light is at one
// of them, or they have no plane.
// position, w  see nodes/scene/SceneFrame, SceneLight
float facingOf(FacingPlane plane, SplitVector position, float w)
{
  SplitVector arm = add(position, SplitVector(-w * plane.corner.high, -w * plane.corner.low));
  SplitVector products = multiply(plane.normal, arm);
  float height = add(add(products, turnOnce(products)), turnTwice(products)).high.x;
  SplitVector second = SplitVector(w * plane.toSecond.high, w * plane.toSecond.low);
  SplitVector third = SplitVector(w * plane.toThird.high, w * plane.toThird.low);
  // At a corner the height is zero, and what is computed may not be: 3e-14 is what 48 bits leave open in scene space.
  SplitVector first = SplitVector(vec3(0.0), vec3(0.0));
  float nearest = min(distanceBetween(arm, first), min(distanceBetween(arm, second), distanceBetween(arm, third)));
  return nearest <= w * 3e-14 ? 0.0 : sign(height);
}
