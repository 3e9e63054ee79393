// edgeSilhouette.glsl - chunk: how often an edge bounds the volumes of all lights, from the facing of its triangles.
// there, back  bits of the triangle that runs through the edge as it is given, and of the one that runs back, as
//              facingBitsOf() has them; a triangle that is missing has none
// closed       bits of the lights of Casting::LightFacing: averted triangles do not cast
// Gives bits of the lights for which it does, x as the edge runs, y the other way, z twice.
uvec3 silhouetteBits(uvec2 there, uvec2 back, uint closed)
{
  there.y &= ~closed;
  back.y &= ~closed;
  return uvec3((there.x & ~back.x) | (back.y & ~there.y), (back.x & ~there.x) | (there.y & ~back.y),
               (there.x & back.y) | (there.y & back.x));
}
