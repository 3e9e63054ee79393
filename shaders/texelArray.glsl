// texelArray.glsl - chunk: where the texels of a nodes/drawable/gl/TexelArray are.
// Rows are filled from the left, layers from the bottom.
// index  of a texel, 0 or more
// size   width and height of a layer: TexelArray::getWidth(), getHeight()
// Gives column, row and layer, as texelFetch() of a [iu]sampler2DArray takes them.
ivec3 texelPlace(int index, ivec2 size)
{
  int row = index / size.x;
  return ivec3(index - row * size.x, row % size.y, row / size.y);
}
