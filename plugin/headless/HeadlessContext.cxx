#include "HeadlessContext.h"

#include <cstdlib>
#include <stdexcept>
#include <vector>

#include "EGLContext.h"
#include "GLFunctions.h"
#include "OSMesaContext.h"

namespace shadow
{

namespace
{

template <class Context>
std::unique_ptr<HeadlessContext> make()
{
  auto context = std::make_unique<Context>();
  vtkShadowSetGLLookup(&Context::getFunction);
  return context;
}

/// By name; empty: whatever there is. It is one GL for the whole process, so the first that gives a context is
/// kept.
std::string& chosenBackend()
{
  static std::string chosen = []
  {
    const char* value = std::getenv("VTKSHADOW_HEADLESS");
    return std::string(value != nullptr ? value : "");
  }();
  return chosen;
}

} // namespace

std::unique_ptr<HeadlessContext> makeHeadlessContext(const std::string& preferred, std::string& error)
{
  std::string& chosen = chosenBackend();
  if (!chosen.empty() && chosen != "osmesa" && chosen != "egl")
  {
    error = "VTKSHADOW_HEADLESS is " + chosen + ", and not osmesa or egl";
    return nullptr;
  }
  std::vector<std::string> backends{chosen};
  if (chosen.empty())
  {
    backends = {preferred, preferred == "egl" ? "osmesa" : "egl"};
  }
  for (const std::string& backend : backends)
  {
    try
    {
      auto context = backend == "egl" ? make<EGLContext>() : make<OSMesaContext>();
      chosen = backend;
      return context;
    }
    catch (const std::runtime_error& reason)
    {
      error += (error.empty() ? "" : "; ") + std::string(reason.what());
    }
  }
  return nullptr;
}

} // namespace shadow
