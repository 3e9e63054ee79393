#ifndef shadow_examples_ShadowRun_h
#define shadow_examples_ShadowRun_h

#include "ModelReader.h"
#include "OutputNames.h"
#include "Progress.h"
#include "RenderOptions.h"
#include "VtkMessages.h"

#include <nlohmann/json.hpp>
#include <vtkBoundingBox.h>
#include <vtkNew.h>

#include <set>
#include <string>
#include <vector>

class vtkHeadlessRenderWindow;
class vtkRenderer;
class vtkShadowVolumePass;

namespace shadow::examples
{

/// One call of shadow_render, from options to files.
class ShadowRun
{
public:
  explicit ShadowRun(RenderOptions options);
  ~ShadowRun();
  ShadowRun(const ShadowRun&) = delete;
  ShadowRun& operator=(const ShadowRun&) = delete;

  /// Checks, reads, draws and writes, in this order: what can be found wrong early is found before the long
  /// work.
  ///
  /// @throws UserError; the files that are written by then stay
  void run();

private:
  std::vector<LightOption> lightsOf(int frame) const;

  void readModels();
  void openWindow();
  void setUpScene();
  void setUpView();
  void checkLights(const vtkBoundingBox& floor) const;
  void drawFrame(int frame);
  void checkDrawing();
  void writeFrame(int frame);
  void writeMasks(int frame);
  void writeReport();
  void warn(const std::string& text);

  RenderOptions options; ///< lights and camera are filled in where the user gave none
  OutputNames names;
  int frameCount;

  Progress progress;
  VtkMessages messages;
  std::set<std::string> warned; ///< so that frames do not repeat each other

  std::vector<Model> models;
  vtkBoundingBox modelBounds;
  std::vector<Vector3> modelPoints;
  vtkNew<vtkHeadlessRenderWindow> window;
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkShadowVolumePass> pass;

  nlohmann::ordered_json frameReports;
};

} // namespace shadow::examples

#endif
