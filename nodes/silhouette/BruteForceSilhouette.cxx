#include "BruteForceSilhouette.h"

#include <algorithm>
#include <cstddef>

#include "EdgeScan.h"
#include "FacingDecider.h"

namespace shadow
{

namespace
{

/// Words of FacingBits that one thread takes at a time: some ten microseconds.
constexpr std::size_t wordsAPart = 1024;

std::size_t countParts(std::size_t words)
{
  return (words + wordsAPart - 1) / wordsAPart;
}

} // namespace

bool BruteForceSilhouette::isParallel(const SEDGeometry& geometry) const
{
  return this->parallelFor && geometry.getPlaneBlocks().size() >= 4 * wordsAPart;
}

void BruteForceSilhouette::face(const SEDGeometry& geometry, const glm::dvec4& lightMC,
                                LightFacing& facing) const
{
  const FacingDecider decider(geometry, lightMC);
  if (!this->isParallel(geometry) || !decider.isLit())
  {
    computeFacing(geometry, lightMC, facing);
    return;
  }
  facing.mixedWords.reset();
  facing.towards.resize(geometry.getTriangles().size());
  facing.away.resize(geometry.getTriangles().size());
  const std::size_t words = geometry.getPlaneBlocks().size();
  this->parallelFor(countParts(words), [&](std::size_t begin, std::size_t end)
                    { decider.decide(wordsAPart * begin, std::min(wordsAPart * end, words), facing); });
}

std::vector<SilhouetteEdge> BruteForceSilhouette::find(const SEDGeometry& geometry, const LightFacing& facing,
                                                       Casting casting) const
{
  const EdgeScan scan(geometry, facing, casting);
  const std::size_t words = geometry.getPlaneBlocks().size();
  std::vector<SilhouetteEdge> silhouette;
  if (!this->isParallel(geometry))
  {
    scan.addWords(0, words, silhouette);
  }
  else
  {
    std::vector<std::vector<SilhouetteEdge>> parts(countParts(words));
    this->parallelFor(parts.size(),
                      [&](std::size_t begin, std::size_t end)
                      {
                        for (std::size_t part = begin; part < end; ++part)
                        {
                          scan.addWords(wordsAPart * part, std::min(wordsAPart * (part + 1), words),
                                        parts[part]);
                        }
                      });
    for (const std::vector<SilhouetteEdge>& part : parts)
    {
      silhouette.insert(silhouette.end(), part.begin(), part.end());
    }
  }
  scan.addBorders(silhouette);
  return silhouette;
}

} // namespace shadow
