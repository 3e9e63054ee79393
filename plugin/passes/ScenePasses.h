#ifndef ScenePasses_h
#define ScenePasses_h

#include <vtkLightsPass.h>
#include <vtkNew.h>
#include <vtkOpaquePass.h>
#include <vtkOverlayPass.h>
#include <vtkSmartPointer.h>
#include <vtkTranslucentPass.h>
#include <vtkVolumetricPass.h>

class vtkOpenGLRenderer;
class vtkRenderPass;
class vtkRenderState;
class vtkWindow;

namespace shadow
{

/// Draws a scene, part by part, as VTK does without a pass, with what the renderer's flags ask for.
class ScenePasses
{
public:
  ScenePasses();

  /// Does what comes before a pass draws the scene, and has it called back: sets viewport and background
  /// where nothing above it has, and leaves picking to the selector, which draws all props itself.
  /// @param complete  the pass draws a scene, and not something over what is there
  /// @param rendered  props that were drawn
  /// @return true when nothing is left to do
  bool renderInstead(vtkRenderPass* pass, bool complete, vtkOpenGLRenderer* renderer, const vtkRenderState* s,
                     int& rendered);

  /// What to draw opaque props with: VTK's opaque pass, or one that has the renderer do it, where its UseSSAO
  /// or UseHiddenLineRemoval ask for more.
  /// @param complete  the flags count
  vtkRenderPass* chooseOpaque(const vtkRenderState* s, bool complete) const;

  /// Whether chooseOpaque() gave one that just draws each prop.
  bool isPlain(const vtkRenderPass* chosen) const { return chosen == this->opaque; }

  int drawLights(const vtkRenderState* s); ///< @return as drawRest()

  /// Draws all that is not opaque: translucent, by the renderer's settings; FXAA; volumes; overlays.
  /// @return props that were drawn
  int drawRest(const vtkRenderState* s);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  bool drawWithCamera(vtkRenderPass* pass, bool complete, vtkOpenGLRenderer* renderer,
                      const vtkRenderState* s);

  vtkNew<vtkLightsPass> lights;
  vtkNew<vtkOpaquePass> opaque;
  vtkSmartPointer<vtkRenderPass> opaqueByRenderer;
  vtkNew<vtkTranslucentPass> translucent;
  vtkNew<vtkVolumetricPass> volumetric;
  vtkNew<vtkOverlayPass> overlay;
  bool hasCamera = false; ///< while a pass draws that renderInstead() has called back
};

} // namespace shadow

#endif
