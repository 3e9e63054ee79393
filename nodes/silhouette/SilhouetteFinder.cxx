#include "SilhouetteFinder.h"

#include <stdexcept>
#include <utility>

#include "AutoSilhouette.h"
#include "BruteForceSilhouette.h"
#include "HierarchicalSilhouette.h"

namespace shadow
{

namespace
{

std::unique_ptr<SilhouetteFinder> construct(SilhouetteMethod method, ParallelFor parallelFor)
{
  switch (method)
  {
  case SilhouetteMethod::Auto:
    return std::make_unique<AutoSilhouette>();
  case SilhouetteMethod::BruteForce:
    return std::make_unique<BruteForceSilhouette>(std::move(parallelFor));
  case SilhouetteMethod::Hierarchical:
    return std::make_unique<HierarchicalSilhouette>();
  }
  throw std::invalid_argument("unknown silhouette method");
}

} // namespace

const std::vector<SilhouetteMethod>& getSilhouetteMethods()
{
  static const std::vector<SilhouetteMethod> methods = {SilhouetteMethod::Auto, SilhouetteMethod::BruteForce,
                                                        SilhouetteMethod::Hierarchical};
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
  case SilhouetteMethod::Hierarchical:
    return "hierarchical";
  }
  throw std::invalid_argument("unknown silhouette method");
}

std::unique_ptr<SilhouetteFinder> makeSilhouetteFinder(SilhouetteMethod method, ParallelFor parallelFor)
{
  std::unique_ptr<SilhouetteFinder> finder = construct(method, std::move(parallelFor));
  finder->method = method;
  return finder;
}

} // namespace shadow
