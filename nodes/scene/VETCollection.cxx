#include "VETCollection.h"

namespace shadow
{

const VETRange* VETCollection::find(const NodePath& path) const
{
  const auto place = this->rangeOfPath.find(path);
  return place == this->rangeOfPath.end() ? nullptr : &this->ranges[place->second];
}

std::size_t VETCollection::getMemorySize() const
{
  return (this->high.capacity() + this->low.capacity()) * sizeof(glm::vec3) +
         this->triangles.capacity() * sizeof(this->triangles[0]) +
         this->reversed.getWords().capacity() * sizeof(std::uint64_t) + this->edges.capacity() * sizeof(Edge);
}

} // namespace shadow
