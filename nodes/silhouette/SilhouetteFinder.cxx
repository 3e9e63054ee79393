#include "SilhouetteFinder.h"

#include <atomic>
#include <stdexcept>
#include <utility>

#include "AutoSilhouette.h"
#include "BruteForceSilhouette.h"
#include "EdgeBufferSilhouette.h"
#include "HierarchicalSilhouette.h"
#include "HybridSilhouette.h"
#include "TopologyAwareMeshSilhouette.h"
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

std::unique_ptr<SilhouetteFinder> construct(SilhouetteMethod method, double coplanarTolerance,
                                            ParallelFor parallelFor)
{
  switch (method)
  {
  case SilhouetteMethod::Auto:
    return std::make_unique<AutoSilhouette>();
  case SilhouetteMethod::BruteForce:
    return std::make_unique<BruteForceSilhouette>(std::move(parallelFor));
  case SilhouetteMethod::EdgeBuffer:
    return std::make_unique<EdgeBufferSilhouette>();
  case SilhouetteMethod::Triangular:
    return std::make_unique<TriangularSilhouette>();
  case SilhouetteMethod::VisibleNonVisible:
    return std::make_unique<VisibleNonVisibleSilhouette>();
  case SilhouetteMethod::Hybrid:
    return std::make_unique<HybridSilhouette>(coplanarTolerance);
  case SilhouetteMethod::Hierarchical:
    return std::make_unique<HierarchicalSilhouette>();
  case SilhouetteMethod::TopologyAwareMesh:
    return std::make_unique<TopologyAwareMeshSilhouette>();
  default:
    throw std::invalid_argument(toString(method) + " finds silhouettes on the GPU only");
  }
}

} // namespace

SilhouetteFinder::SilhouetteFinder() : id(nextId()) {}

std::optional<LightFacing> SilhouetteFinder::simplifyFacing(const SEDGeometry&, const LightFacing&) const
{
  return std::nullopt;
}

const std::vector<SilhouetteMethod>& getSilhouetteMethods()
{
  static const std::vector<SilhouetteMethod> methods = {SilhouetteMethod::Auto,
                                                        SilhouetteMethod::BruteForce,
                                                        SilhouetteMethod::EdgeBuffer,
                                                        SilhouetteMethod::Triangular,
                                                        SilhouetteMethod::VisibleNonVisible,
                                                        SilhouetteMethod::Hybrid,
                                                        SilhouetteMethod::Hierarchical,
                                                        SilhouetteMethod::TopologyAwareMesh,
                                                        SilhouetteMethod::FacingTexture,
                                                        SilhouetteMethod::FacingTextureResident,
                                                        SilhouetteMethod::VertexTexture,
                                                        SilhouetteMethod::VertexExtrusion,
                                                        SilhouetteMethod::GeometryShader,
                                                        SilhouetteMethod::Compute};
  return methods;
}

std::string toString(SilhouetteMethod method)
{
  switch (method)
  {
  case SilhouetteMethod::Auto:
    return "auto";
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
  case SilhouetteMethod::Hierarchical:
    return "hierarchical";
  case SilhouetteMethod::TopologyAwareMesh:
    return "topology-aware-mesh";
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

std::unique_ptr<SilhouetteFinder> makeSilhouetteFinder(SilhouetteMethod method, double coplanarTolerance,
                                                       ParallelFor parallelFor)
{
  std::unique_ptr<SilhouetteFinder> finder = construct(method, coplanarTolerance, std::move(parallelFor));
  finder->method = method;
  return finder;
}

} // namespace shadow
