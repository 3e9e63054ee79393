#include "SilhouetteFinder.h"

#include <stdexcept>

#include "BruteForceSilhouette.h"

namespace shadow
{

std::string toString(SilhouetteMethod method)
{
  switch (method)
  {
  case SilhouetteMethod::BruteForce:
    return "brute-force";
  case SilhouetteMethod::FacingTexture:
    return "facing-texture";
  case SilhouetteMethod::FacingTextureResident:
    return "facing-texture-resident";
  case SilhouetteMethod::VertexTexture:
    return "vertex-texture";
  case SilhouetteMethod::VertexExtrusion:
    return "vertex-extrusion";
  case SilhouetteMethod::Compute:
    return "compute";
  }
  throw std::invalid_argument("unknown silhouette method");
}

std::unique_ptr<SilhouetteFinder> makeSilhouetteFinder(SilhouetteMethod method)
{
  switch (method)
  {
  case SilhouetteMethod::BruteForce:
    return std::make_unique<BruteForceSilhouette>();
  default:
    throw std::invalid_argument(toString(method) + " finds silhouettes on the GPU only");
  }
}

} // namespace shadow
