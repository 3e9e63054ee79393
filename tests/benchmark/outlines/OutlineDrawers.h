#pragma once

#include <memory>
#include <string>
#include <vector>

#include <vtkHeadlessRenderWindow.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

class vtkPolyData;

namespace shadow::benchmarks
{

/// One mesh in a window of its own, drawn with outlines in one way.
class OutlineDrawer
{
public:
  virtual ~OutlineDrawer() = default;
  OutlineDrawer(const OutlineDrawer&) = delete;
  OutlineDrawer& operator=(const OutlineDrawer&) = delete;

  virtual std::string getName() const = 0;

  /// Width of the lines in pixels, where the way of drawing has any.
  virtual void setLineWidth(double width) { static_cast<void>(width); }

  virtual bool hasLineWidth() const { return true; }

  /// Draws white surfaces without light on white, so that the lines are what is black.
  virtual void useMaskColours();

  /// Draws, and tells which pixels are line: 255, else 0; bottom row first.
  virtual std::vector<unsigned char> readLines();

  /// Milliseconds of a frame after the camera has gone round the mesh by some degrees.
  virtual double drawNext();

  vtkRenderer* getRenderer() { return this->renderer; }

protected:
  OutlineDrawer(vtkPolyData* mesh, int width, int height);

  /// RGB of the window, bottom row first.
  std::vector<unsigned char> readPicture();

  vtkNew<vtkHeadlessRenderWindow> window;
  vtkNew<vtkRenderer> renderer;
};

/// The mesh without lines; vtkSilhouettePass; lines of vtkPolyDataSilhouette; vtkOutlineGlowPass.
std::unique_ptr<OutlineDrawer> makePlainDrawer(vtkPolyData* mesh, int width, int height);
std::unique_ptr<OutlineDrawer> makePassDrawer(vtkPolyData* mesh, int width, int height);
std::unique_ptr<OutlineDrawer> makeFilterDrawer(vtkPolyData* mesh, int width, int height);
std::unique_ptr<OutlineDrawer> makeGlowDrawer(vtkPolyData* mesh, int width, int height);

} // namespace shadow::benchmarks
