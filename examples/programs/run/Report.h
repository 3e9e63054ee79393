#ifndef shadow_examples_Report_h
#define shadow_examples_Report_h

#include "RenderOptions.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

class vtkRenderWindow;
class vtkShadowVolumePass;
class vtkSilhouettePass;

namespace shadow::examples
{

struct Model;

/// The vendor, renderer and version that the GL of a window reports, and VTK's version.
nlohmann::ordered_json describeSystem(vtkRenderWindow* window);

nlohmann::ordered_json describeModels(const std::vector<Model>& models);
nlohmann::ordered_json describeLights(const std::vector<LightOption>& lights);
nlohmann::ordered_json describeCamera(const CameraOption& camera, const std::optional<double>& parallelScale);
nlohmann::ordered_json describeShadowSettings(const RenderOptions& options);

/// Status, statistics, skipped casters and milliseconds of a pass's last rendering.
///
/// @param frameMilliseconds  of the whole picture, as the caller measured them
nlohmann::ordered_json describeRendering(vtkShadowVolumePass* pass, double frameMilliseconds);

/// Status, statistics, skipped props and milliseconds of a pass's last rendering.
///
/// @param frameMilliseconds  of the whole picture, as the caller measured them
nlohmann::ordered_json describeOutlines(vtkSilhouettePass* pass, double frameMilliseconds);

/// Indented, with a line end. Bytes of file names that are no UTF-8 are replaced.
std::string toText(const nlohmann::ordered_json& report);

} // namespace shadow::examples

#endif
