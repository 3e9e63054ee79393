#include "HeadlessContext.h"

#include <cstdlib>
#include <stdexcept>

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

std::string chosenBackend()
{
  const char* value = std::getenv("VTKSHADOW_HEADLESS");
  return value != nullptr && *value != '\0' ? value : "osmesa";
}

} // namespace

std::unique_ptr<HeadlessContext> makeHeadlessContext(std::string& error)
{
  static const std::string backend = chosenBackend();
  try
  {
    if (backend == "osmesa")
    {
      return make<OSMesaContext>();
    }
    if (backend == "egl")
    {
      return make<EGLContext>();
    }
    error = "VTKSHADOW_HEADLESS is " + backend + ", and not osmesa or egl";
  }
  catch (const std::runtime_error& reason)
  {
    error = reason.what();
  }
  return nullptr;
}

} // namespace shadow
