#ifndef PictureScale_h
#define PictureScale_h

class vtkOpenGLRenderWindow;
class vtkOpenGLRenderer;

namespace shadow
{

/// How many times as large as the window the picture is that a frame is a part of, so that widths in pixels
/// keep their share of it. 1 but for pictures that are put together from tiles.
///
/// A vtkWindowToImageFilter tells the window its scale. A vtkRenderLargeImage tells nobody: it narrows the
/// view and moves the camera's window centre over an even grid, beginning at the lower left, where nobody
/// else looks.
class PictureScale
{
public:
  double update(vtkOpenGLRenderer* renderer, vtkOpenGLRenderWindow* window);

private:
  int tiles = 1;           ///< in each direction
  double viewAngle = 0.0;  ///< of these
  double viewHeight = 0.0; ///< of these, for a parallel projection
};

} // namespace shadow

#endif
