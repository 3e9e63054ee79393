#ifndef shadow_examples_RenderRun_h
#define shadow_examples_RenderRun_h

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
class vtkImageData;
class vtkRenderer;

namespace shadow::examples
{

/// One call of a program, from options to files. Each program says which passes draw, and what masks there
/// are.
class RenderRun
{
public:
  virtual ~RenderRun();
  RenderRun(const RenderRun&) = delete;
  RenderRun& operator=(const RenderRun&) = delete;

  /// Checks, reads, draws and writes, in this order: what can be found wrong early is found before the long
  /// work.
  ///
  /// @throws UserError; the files that are written by then stay
  void run();

protected:
  /// @param program    its name, for messages
  /// @param maskCount  masks that writeMasks() writes for each picture
  RenderRun(std::string program, RenderOptions options, std::size_t maskCount);

  /// Gives the renderer its pass, set up as the options say.
  virtual void attachPasses(vtkRenderer* renderer) = 0;

  /// Looks at the passes after each picture. @throws UserError when it is of no use
  virtual void checkDrawing() = 0;

  /// Writes the masks of a picture; called when they are asked for.
  virtual void writeMasks(int frame, nlohmann::ordered_json& report) = 0;

  virtual nlohmann::ordered_json describeSettings() const = 0;

  /// @param milliseconds  of the whole picture
  virtual nlohmann::ordered_json describeFrame(double milliseconds) = 0;

  /// For checkDrawing(): a warning where a pass left something out, an error where it drew nothing of its
  /// own.
  ///
  /// @param what   it draws
  /// @param cause  what the pass says
  void checkStatus(bool complete, bool partial, const std::string& what, const std::string& cause);

  /// For writeMasks().
  void writeMask(const std::string& name, vtkImageData* mask, nlohmann::ordered_json& report) const;

  const OutputNames& getNames() const { return this->names; }

  RenderOptions options; ///< lights and camera are filled in where the user gave none

private:
  std::vector<LightOption> lightsOf(int frame) const;

  void readModels();
  void openWindow();
  void checkMemory();
  void setUpScene();
  void setUpView();
  void checkLights(const vtkBoundingBox& floor) const;
  void drawFrame(int frame);
  void checkMessages();
  void writeFrame(int frame);
  void writeReport();
  void warn(const std::string& text);

  std::string program;
  OutputNames names;
  int frameCount;

  Progress progress;
  VtkMessages messages;
  std::string said;             ///< by the passes of the last picture
  std::set<std::string> warned; ///< so that frames do not repeat each other

  std::vector<Model> models;
  vtkBoundingBox modelBounds;
  std::vector<Vector3> modelPoints;
  vtkNew<vtkHeadlessRenderWindow> window;
  vtkNew<vtkRenderer> renderer;

  nlohmann::ordered_json frameReports;
};

} // namespace shadow::examples

#endif
