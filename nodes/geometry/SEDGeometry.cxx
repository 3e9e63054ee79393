#include "SEDGeometry.h"

namespace shadow
{

namespace
{

template <typename T>
std::size_t bytesOf(const std::vector<T>& values)
{
  return values.capacity() * sizeof(T);
}

} // namespace

std::size_t SEDGeometry::getMemorySize() const
{
  return bytesOf(this->positions) + bytesOf(this->triangles) + bytesOf(this->reversed.getWords()) +
         bytesOf(this->inputReversed.getWords()) + bytesOf(this->planes) + bytesOf(this->planeErrors) +
         bytesOf(this->edges) + this->prepared->getMemorySize();
}

} // namespace shadow
