#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include <vtkActor.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkRenderPass.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

namespace shadow::test
{

/// Windows that share actors, mappers and passes, and all that may be done to them. Beside each object stands
/// what it is, so that its picture can be drawn once more by objects that share nothing.
class SharedWindows
{
public:
  static constexpr std::size_t windowCount = 3;
  static constexpr std::size_t actorCount = 3;

  /// How a renderer draws.
  enum class Drawing
  {
    Plain,           ///< no pass
    Steps,           ///< VTK's own passes
    Shadows,         ///< vtkShadowVolumePass
    Lines,           ///< vtkSilhouettePass
    LinesOverShadows ///< vtkSilhouettePass with a vtkShadowVolumePass as its delegate
  };

  /// A change. @p one and @p other number windows, and actors where the change is one of actors.
  struct Operation
  {
    std::string name;
    bool keepsContext; ///< what was current has to be so again afterwards; VTK itself switches in some
    void (SharedWindows::*run)(std::size_t one, std::size_t other);
  };
  static const std::vector<Operation>& operations();

  /// All windows show all actors, and share one pass.
  explicit SharedWindows(Drawing drawing);

  vtkOpenGLRenderWindow* getWindow(std::size_t one) { return this->stages[one].window; }

  /// Renders, and counts the values of the picture that differ from those of a window that shares nothing.
  std::size_t countWrong(std::size_t one);

private:
  struct Stage
  {
    vtkSmartPointer<vtkOpenGLRenderWindow> window;
    vtkSmartPointer<vtkRenderer> renderer;
    Drawing drawing;
    std::array<int, 2> size;
    std::array<bool, actorCount> shown;
  };

  struct Prop
  {
    vtkSmartPointer<vtkActor> actor;
    int shape; ///< of its mapper
  };

  /// The picture of a stage by objects that share nothing. Drawn once for each that differs.
  const std::vector<unsigned char>& drawAlone(const Stage& stage) const;

  void showActors(const Stage& stage) const;

  static void openWindow(Stage& stage);
  static void makeRenderer(Stage& stage, vtkRenderPass* pass);
  static vtkSmartPointer<vtkActor> makeActor(std::size_t place, int shape);
  static vtkSmartPointer<vtkRenderPass> makePass(Drawing drawing);
  void setDrawing(std::size_t one, Drawing drawing);

  void newShadows(std::size_t one, std::size_t other);
  void newLines(std::size_t one, std::size_t other);
  void newLinesOverShadows(std::size_t one, std::size_t other);
  void newSteps(std::size_t one, std::size_t other);
  void noPass(std::size_t one, std::size_t other);
  void sharePass(std::size_t one, std::size_t other);
  void keepPass(std::size_t one, std::size_t other);
  void dropKeptPass(std::size_t one, std::size_t other);
  void replaceWindow(std::size_t one, std::size_t other);
  void finalizeWindow(std::size_t one, std::size_t other);
  void resizeWindow(std::size_t one, std::size_t other);
  void replaceRenderer(std::size_t one, std::size_t other);
  void swapRenderers(std::size_t one, std::size_t other);
  void releasePass(std::size_t one, std::size_t other);
  void releaseRenderer(std::size_t one, std::size_t other);
  void releaseActor(std::size_t one, std::size_t other);
  void toggleActor(std::size_t one, std::size_t other);
  void replaceActor(std::size_t one, std::size_t other);
  void shareMapper(std::size_t one, std::size_t other);
  void replaceMapper(std::size_t one, std::size_t other);

  std::array<Stage, windowCount> stages;
  std::array<Prop, actorCount> props;
  vtkSmartPointer<vtkRenderPass> kept;
  int shapes = 0; ///< so far
};

} // namespace shadow::test
