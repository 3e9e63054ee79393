#include "SilhouetteFinder.h"

#include <atomic>
#include <stdexcept>

#include "BruteForceSilhouette.h"
#include "EdgeBufferSilhouette.h"
#include "HybridSilhouette.h"
#include "TriangularSilhouette.h"
#include "VisibleNonVisibleSilhouette.h"

namespace shadow
{

namespace
{

std::uint64_t nextId()
{
  static std::atomic<std::uint64_t> last{0};
  return ++last;
}

} // namespace

SilhouetteFinder::SilhouetteFinder() : id(nextId()) {}

std::optional<LightFacing> SilhouetteFinder::simplifyFacing(const SEDGeometry&, const LightFacing&) const
{
  return std::nullopt;
}

std::string toString(SilhouetteMethod method)
{
  switch (method)
  {
  case SilhouetteMethod::BruteForce:
    return "brute-force";
  case SilhouetteMethod::EdgeBuffer:
    return "edge-buffer";
  case SilhouetteMethod::Triangular:
    return "triangular";
  case SilhouetteMethod::VisibleNonVisible:
    return "visible-nonvisible";
  case SilhouetteMethod::Hybrid:
    return "hybrid";
  case SilhouetteMethod::FacingTexture:
    return "facing-texture";
  case SilhouetteMethod::FacingTextureResident:
    return "facing-texture-resident";
  case SilhouetteMethod::VertexTexture:
    return "vertex-texture";
  case SilhouetteMethod::VertexExtrusion:
    return "vertex-extrusion";
  case SilhouetteMethod::GeometryShader:
    return "geometry-shader";
  case SilhouetteMethod::Compute:
    return "compute";
  }
  throw std::invalid_argument("unknown silhouette method");
}

std::unique_ptr<SilhouetteFinder> makeSilhouetteFinder(SilhouetteMethod method, double coplanarTolerance)
{
  switch (method)
  {
  case SilhouetteMethod::BruteForce:
    return std::make_unique<BruteForceSilhouette>();
  case SilhouetteMethod::EdgeBuffer:
    return std::make_unique<EdgeBufferSilhouette>();
  case SilhouetteMethod::Triangular:
    return std::make_unique<TriangularSilhouette>();
  case SilhouetteMethod::VisibleNonVisible:
    return std::make_unique<VisibleNonVisibleSilhouette>();
  case SilhouetteMethod::Hybrid:
    return std::make_unique<HybridSilhouette>(coplanarTolerance);
  default:
    throw std::invalid_argument(toString(method) + " finds silhouettes on the GPU only");
  }
}

} // namespace shadow
