#include "Report.h"

#include "ModelReader.h"

#include <vtkRenderWindow.h>
#include <vtkShadowVolumePass.h>
#include <vtkSilhouettePass.h>
#include <vtkVersion.h>

#include <sstream>

namespace shadow::examples
{
namespace
{

using Json = nlohmann::ordered_json;

// The rest of the line of a capabilities report that begins with `key`.
std::string capability(const std::string& capabilities, const std::string& key)
{
  std::istringstream lines(capabilities);
  for (std::string line; std::getline(lines, line);)
  {
    if (line.rfind(key, 0) == 0)
    {
      const std::size_t begin = line.find_first_not_of(' ', key.size());
      return begin == std::string::npos ? "" : line.substr(begin);
    }
  }
  return {};
}

Json describeLight(const LightOption& light)
{
  switch (light.kind)
  {
  case LightOption::Kind::Directional:
    return {{"kind", "directional"}, {"direction", light.direction}};
  case LightOption::Kind::Spot:
    return {{"kind", "spot"},
            {"position", light.position},
            {"target", light.target},
            {"coneAngle", light.coneAngle}};
  default:
    return {{"kind", "point"}, {"position", light.position}};
  }
}

// The passes number their status alike.
static_assert(static_cast<int>(vtkShadowVolumePass::STATUS_NOT_RENDERED) ==
              static_cast<int>(vtkSilhouettePass::STATUS_NOT_RENDERED));

std::string statusName(int status)
{
  switch (status)
  {
  case vtkShadowVolumePass::STATUS_OK:
    return "ok";
  case vtkShadowVolumePass::STATUS_PARTIAL:
    return "partial";
  case vtkShadowVolumePass::STATUS_NOT_SUPPORTED:
    return "not supported";
  default:
    return "not rendered";
  }
}

// Casters for each silhouette method that was used.
Json describeMethods(vtkShadowVolumePass* pass)
{
  Json result = Json::object();
  for (std::size_t method = 0; method < silhouetteNames().size(); ++method)
  {
    const int casters = pass->GetNumberOfCastersFoundBy(static_cast<int>(method));
    if (casters > 0)
    {
      result[silhouetteNames()[method]] = casters;
    }
  }
  return result;
}

// A prop is reported as "name: reason"; the name may hold a colon itself, the reason does not.
Json describeSkipped(const std::string& kind, const std::string& text)
{
  const std::size_t colon = text.rfind(": ");
  return colon == std::string::npos ? Json{{kind, ""}, {"reason", text}}
                                    : Json{{kind, text.substr(0, colon)}, {"reason", text.substr(colon + 2)}};
}

Json describeSkippedCasters(vtkShadowVolumePass* pass)
{
  Json skipped = Json::array();
  for (int i = 0; i < pass->GetNumberOfSkippedCasters(); ++i)
  {
    skipped.push_back(describeSkipped("caster", pass->GetSkippedCaster(i)));
  }
  return skipped;
}

Json describeSkippedProps(vtkSilhouettePass* pass)
{
  Json skipped = Json::array();
  for (int i = 0; i < pass->GetNumberOfSkippedProps(); ++i)
  {
    skipped.push_back(describeSkipped("prop", pass->GetSkippedProp(i)));
  }
  return skipped;
}

} // namespace

Json describeSystem(vtkRenderWindow* window)
{
  const char* text = window->ReportCapabilities();
  const std::string capabilities = text == nullptr ? "" : text;
  return {{"vtk", vtkVersion::GetVTKVersion()},
          {"glVendor", capability(capabilities, "OpenGL vendor string:")},
          {"glRenderer", capability(capabilities, "OpenGL renderer string:")},
          {"glVersion", capability(capabilities, "OpenGL version string:")}};
}

Json describeModels(const std::vector<Model>& models)
{
  Json list = Json::array();
  for (const Model& model : models)
  {
    list.push_back({{"file", model.file}, {"triangles", model.triangles}});
  }
  return list;
}

Json describeLights(const std::vector<LightOption>& lights)
{
  Json list = Json::array();
  for (const LightOption& light : lights)
  {
    list.push_back(describeLight(light));
  }
  return list;
}

Json describeCamera(const CameraOption& camera, const std::optional<double>& parallelScale)
{
  Json result = {{"projection", parallelScale ? "parallel" : "perspective"},
                 {"position", camera.position},
                 {"focalPoint", camera.focalPoint},
                 {"viewUp", camera.viewUp}};
  if (parallelScale)
  {
    result["parallelScale"] = *parallelScale;
  }
  else
  {
    result["viewAngle"] = camera.viewAngle;
  }
  return result;
}

Json describeShadowSettings(const RenderOptions& options)
{
  return {{"stencil", stencilNames()[options.stencilMethod]},
          {"silhouette", silhouetteNames()[options.silhouetteMethod]},
          {"compositing", compositingNames()[options.compositing]},
          {"samples", options.samples}};
}

Json describeRendering(vtkShadowVolumePass* pass, double frameMilliseconds)
{
  Json result = {{"status", statusName(pass->GetStatus())}, {"message", pass->GetStatusMessage()}};
  result["triangles"] = {{"prePass", pass->GetPrePassTriangles()},   {"ambient", pass->GetAmbientTriangles()},
                         {"sides", pass->GetSideTriangles()},        {"caps", pass->GetCapTriangles()},
                         {"lighting", pass->GetLightingTriangles()}, {"total", pass->GetTotalTriangles()}};
  result["silhouetteEdges"] = pass->GetSilhouetteEdges();
  result["shadowLights"] = pass->GetNumberOfShadowLights();
  result["keptLights"] = pass->GetNumberOfKeptLights();
  result["countedPixels"] = pass->GetCountedPixels();
  result["batchedMeshes"] = pass->GetNumberOfBatchedMeshes();
  result["casters"] = {{"drawn", pass->GetNumberOfCasters()},
                       {"zfail", pass->GetNumberOfZFailCasters()},
                       {"rebuilt", pass->GetNumberOfRebuiltVolumes()},
                       {"foundBy", describeMethods(pass)},
                       {"skipped", describeSkippedCasters(pass)}};
  result["memoryBytes"] = pass->GetMemorySize();
  result["milliseconds"] = {
      {"scene", pass->GetSceneMilliseconds()},       {"silhouette", pass->GetSilhouetteMilliseconds()},
      {"prePass", pass->GetPrePassMilliseconds()},   {"stencil", pass->GetStencilMilliseconds()},
      {"lighting", pass->GetLightingMilliseconds()}, {"frame", frameMilliseconds}};
  return result;
}

Json describeOutlines(vtkSilhouettePass* pass, double frameMilliseconds)
{
  Json result = {{"status", statusName(pass->GetStatus())}, {"message", pass->GetStatusMessage()}};
  result["triangles"] = {{"depth", pass->GetDepthTriangles()}, {"lines", pass->GetLineTriangles()}};
  result["edges"] = pass->GetLineEdges();
  result["skipped"] = describeSkippedProps(pass);
  result["memoryBytes"] = pass->GetMemorySize();
  result["milliseconds"] = {{"scene", pass->GetSceneMilliseconds()}, {"edges", pass->GetEdgeMilliseconds()},
                            {"depth", pass->GetDepthMilliseconds()}, {"lines", pass->GetLineMilliseconds()},
                            {"blend", pass->GetBlendMilliseconds()}, {"frame", frameMilliseconds}};
  return result;
}

std::string toText(const Json& report)
{
  return report.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace shadow::examples
