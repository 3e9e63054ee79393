#include "BatchCollector.h"

namespace shadow
{

std::vector<BatchedSurface> BatchCollector::collect(Node& root, std::size_t mostSurfaces)
{
  this->found.clear();
  this->most = mostSurfaces;
  this->triangles = 0;
  this->collected = true;
  this->surfacesAlone = false;
  this->volumesAlone.clear();
  root.accept(*this);
  std::vector<BatchedSurface> result = std::exchange(this->found, {});
  if (result.size() < fewest)
  {
    for (const BatchedSurface& surface : result)
    {
      surface.path->batched = false;
      this->noteAlone(*surface.path);
    }
    result.clear();
  }
  return result;
}

void BatchCollector::apply(SEDGeode& geode)
{
  PathState& path = geode.getPathState(this->getPath());
  const std::size_t count = geode.getGeometry().getTriangles().size();
  // Culled sides need another index buffer, and a pass of their own.
  path.batched = count > 0 && count <= largestMesh && this->found.size() < this->most &&
                 this->triangles + count <= mostTriangles && this->getFaceCulling() == FaceCulling::None &&
                 path.hiddenSide == FaceCulling::None;
  if (!path.batched)
  {
    this->noteAlone(path);
    return;
  }
  const glm::dmat4 wcFromMC = worldFromRelative(geode.getGeometry(), this->getModelToWorld());
  const bool mirrored = glm::determinant(glm::dmat3(wcFromMC)) < 0.0;
  this->found.push_back({geode.getSharedGeometry(), &path, wcFromMC, mirrored});
  this->triangles += count;
}

void BatchCollector::noteAlone(const PathState& path)
{
  this->surfacesAlone = true;
  for (const auto& [light, state] : path.lights)
  {
    if (state.plan.count != StencilCount::Skip)
    {
      this->volumesAlone.insert({light, state.plan.count});
    }
  }
}

} // namespace shadow
