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
  }
  throw std::invalid_argument("unknown silhouette method");
}

std::unique_ptr<SilhouetteFinder> makeSilhouetteFinder(SilhouetteMethod method)
{
  switch (method)
  {
  case SilhouetteMethod::BruteForce:
    return std::make_unique<BruteForceSilhouette>();
  }
  throw std::invalid_argument("unknown silhouette method");
}

} // namespace shadow
