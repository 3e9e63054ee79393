#include "SEDGeometryBatch.h"

#include <cstddef>
#include <utility>

namespace shadow
{

namespace
{

/// Triangles from which on one mesh is enough for all threads. Threads within threads would gain nothing more.
constexpr std::size_t large = 1 << 18;

void build(SEDGeometryJob& job)
{
  job.geometry = buildSEDGeometry(std::move(job.soup), job.options, job.error);
}

} // namespace

void buildSEDGeometries(std::vector<SEDGeometryJob>& jobs, const ParallelFor& parallelFor)
{
  std::vector<SEDGeometryJob*> small;
  for (SEDGeometryJob& job : jobs)
  {
    if (job.soup.triangles.size() < large)
    {
      small.push_back(&job);
    }
    else
    {
      job.options.parallelFor = parallelFor;
      build(job);
    }
  }
  forRanges(parallelFor, small.size(), 1,
            [&small](std::size_t begin, std::size_t end)
            {
              for (std::size_t job = begin; job < end; ++job)
              {
                build(*small[job]);
              }
            });
}

} // namespace shadow
