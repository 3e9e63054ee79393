#ifndef RendererAccess_h
#define RendererAccess_h

#include <vtkOpenGLFXAAFilter.h>
#include <vtkOpenGLRenderer.h>
#include <vtkRenderState.h>

namespace shadow
{

/// What a VTK renderer draws with and keeps to itself: without it the same would be there twice, to be freed when VTK
/// frees the renderer's.
struct RendererAccess : vtkOpenGLRenderer
{
  /// Whether a state has all props that the renderer draws, and not a choice of them.
  static bool hasAllProps(vtkOpenGLRenderer* renderer, const vtkRenderState* s)
  {
    return s->GetRequiredKeys() == nullptr &&
           s->GetPropArray() == first(renderer->*(&RendererAccess::PropArray));
  }

  /// The renderer's own, made if need be.
  static vtkOpenGLFXAAFilter* getFXAAFilter(vtkOpenGLRenderer* renderer)
  {
    auto& filter = renderer->*(&RendererAccess::FXAAFilter);
    if (filter == nullptr)
    {
      filter = vtkOpenGLFXAAFilter::New();
    }
    return filter;
  }

  /// Has the renderer's selector draw what can be picked. @pre there is a selector
  /// @return props that were drawn
  static int select(vtkOpenGLRenderer* renderer, const vtkRenderState* s)
  {
    return (renderer->*(&RendererAccess::UpdateGeometry))(s->GetFrameBuffer());
  }

private:
  // An array up to VTK 9.5, then a vector.
  static vtkProp** first(vtkProp** props) { return props; }
  template <class Vector>
  static vtkProp** first(Vector& props)
  {
    return props.data();
  }
};

} // namespace shadow

#endif
