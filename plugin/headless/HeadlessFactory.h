#ifndef HeadlessFactory_h
#define HeadlessFactory_h

namespace shadow
{

/// From now on vtkRenderWindow::New() gives a vtkHeadlessRenderWindow, and vtkRenderWindowInteractor::New() an interactor
/// that asks no window system. Comes before every other factory, whether registered earlier or later. Further calls do
/// nothing.
///
/// From VTK 9.4 on it is the interactor only, and only where there is no display: the rest VTK has itself. There its
/// windows draw by OSMesa where VTKSHADOW_HEADLESS says so, and VTK_DEFAULT_OPENGL_WINDOW nothing else.
void registerHeadlessFactory();

} // namespace shadow

#endif
