#ifndef RendererAccess_h
#define RendererAccess_h

#include <vector>

#include <vtkOpenGLFXAAFilter.h>
#include <vtkOpenGLRenderer.h>
#include <vtkRenderState.h>

#include "../vtkShadowCompat.h"

namespace shadow
{

/// What a VTK renderer draws with and keeps to itself: without it the same would be there twice, to be freed
/// when VTK frees the renderer's.
struct RendererAccess : vtkOpenGLRenderer
{
  /// Whether a state has all props that the renderer draws, and not a choice of them.
  static bool hasAllProps(vtkOpenGLRenderer* renderer, const vtkRenderState* s)
  {
    return s->GetRequiredKeys() == nullptr &&
           s->GetPropArray() == first(renderer->*(&RendererAccess::PropArray)) &&
           s->GetPropArrayCount() == countProps(renderer);
  }

  static void setNumberOfPropsRendered(vtkOpenGLRenderer* renderer, int count)
  {
    renderer->*(&RendererAccess::NumberOfPropsRendered) = count;
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
#if VTKSHADOW_PROPS_ARE_A_VECTOR
  static vtkProp** first(std::vector<vtkProp*>& props) { return props.data(); }
  static int countProps(vtkOpenGLRenderer* renderer)
  {
    return static_cast<int>((renderer->*(&RendererAccess::PropArray)).size());
  }
#else
  static vtkProp** first(vtkProp** props) { return props; }
  static int countProps(vtkOpenGLRenderer* renderer)
  {
    return renderer->*(&RendererAccess::PropArrayCount);
  }
#endif
};

} // namespace shadow

#endif
