#include "MeshStore.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include <vtkPolyData.h>

#include "MeshImport.h"
#include "SEDGeometryBatch.h"
#include "SmpParallelFor.h"
#include "SweepUnused.h"

namespace shadow
{

namespace
{

/// Two roundings of single precision, for a coordinate as large as the mesh: what sin(2 pi) misses 0 by,
/// times its radius, is less.
double chooseWeldTolerance(vtkPolyData* polyData, const MeshStore::Options& options)
{
  constexpr double rounding = 2.0 * std::numeric_limits<float>::epsilon();
  const double size = options.weldsRounding ? polyData->GetLength() : 0.0;
  return std::max(options.weldTolerance, std::isfinite(size) ? rounding * size : 0.0);
}

} // namespace

void MeshStore::request(vtkPolyData* polyData, const std::shared_ptr<SEDGeode>& shownBefore, const Options& options)
{
  Entry& entry = this->meshes[polyData];
  entry.used = true;
  // GetMTime() covers points and cells as well as a call of Modified() on the data set after a change in
  // place.
  const vtkMTimeType time = polyData->GetMTime();
  const double weldTolerance = chooseWeldTolerance(polyData, options);
  if (entry.polyData != polyData || entry.time != time || entry.weldTolerance != weldTolerance)
  {
    entry.polyData = polyData;
    entry.time = time;
    entry.weldTolerance = weldTolerance;
    const std::shared_ptr<SEDGeode> previous =
        entry.mesh.geode != nullptr ? std::move(entry.mesh.geode) : shownBefore;
    entry.mesh = Mesh();
    this->pending.push_back({&entry, polyData, previous, options.copiesCountOnce});
  }
}

/// Some at a time, so that the triangles of few wait beside the meshes that are made of them.
void MeshStore::build()
{
  constexpr vtkIdType most = 1 << 20; // cells
  for (std::size_t begin = 0; begin < this->pending.size();)
  {
    std::size_t end = begin;
    for (vtkIdType cells = 0; end < this->pending.size() && cells < most; ++end)
    {
      cells += this->pending[end].polyData->GetNumberOfCells();
    }
    this->buildRange(begin, end);
    begin = end;
  }
  this->pending.clear();
}

/// Only the plain triangles see threads: VTK's data sets are read here, one after the other.
void MeshStore::buildRange(std::size_t begin, std::size_t end)
{
  std::vector<SEDGeometryJob> jobs;
  std::vector<Entry*> entries;
  for (std::size_t place = begin; place < end; ++place)
  {
    const Pending& each = this->pending[place];
    TriangleSoup soup = importTriangles(each.polyData);
    if (!soup.triangles.empty())
    {
      SEDGeometryJob& job = jobs.emplace_back();
      job.soup = std::move(soup);
      job.options.weldTolerance = each.entry->weldTolerance;
      job.options.copiesCountOnce = each.copiesCountOnce;
      job.options.previous = each.previous != nullptr ? &each.previous->getGeometry() : nullptr;
      entries.push_back(each.entry);
    }
  }
  buildSEDGeometries(jobs, makeSmpParallelFor());
  for (std::size_t place = 0; place < jobs.size(); ++place)
  {
    Mesh& mesh = entries[place]->mesh;
    mesh.error = std::move(jobs[place].error);
    if (std::optional<SEDGeometry>& geometry = jobs[place].geometry)
    {
      mesh.geode = std::make_shared<SEDGeode>(std::make_shared<const SEDGeometry>(std::move(*geometry)));
    }
  }
}

void MeshStore::dropUnused()
{
  sweepUnused(this->meshes);
  for (auto& [polyData, entry] : this->meshes)
  {
    if (entry.mesh.geode != nullptr)
    {
      entry.mesh.geode->dropUnusedPaths();
    }
  }
}

std::size_t MeshStore::getMemorySize() const
{
  std::size_t bytes = 0;
  for (const auto& [polyData, entry] : this->meshes)
  {
    if (entry.mesh.geode != nullptr)
    {
      bytes += entry.mesh.geode->getGeometry().getMemorySize() + entry.mesh.geode->getMemorySize();
    }
  }
  return bytes;
}

} // namespace shadow
