#ifndef SilhouettePassInternals_h
#define SilhouettePassInternals_h

#include <cstddef>
#include <set>
#include <string>

#include <vtkRenderPass.h>
#include <vtkSmartPointer.h>

#include "OutlineEffect.h"
#include "PassContext.h"
#include "PictureScale.h"
#include "SceneBuilder.h"
#include "ScenePasses.h"
#include "vtkSilhouettePass.h"

/// What vtkSilhouettePass keeps out of its header.
class vtkSilhouettePass::vtkInternals
{
public:
  /// Everything that belongs to one renderer: a pass may serve several.
  struct RendererState
  {
    shadow::PassContext Context;
    shadow::SceneBuilder Builder;
    shadow::OutlineEffect Effect;
    shadow::MessageFilter Messages;
    shadow::PictureScale Scale;

    RendererState(vtkOpenGLRenderer* renderer, vtkOpenGLRenderWindow* window) : Context(renderer, window) {}
    ~RendererState() { this->Release(); }
    void Release()
    {
      this->Context.release([this](bool contextLost) { this->Effect.release(contextLost); });
    }
    std::size_t GetMemorySize() const
    {
      return this->Builder.getMemorySize() + this->Effect.getGraphicsMemorySize();
    }
  };

  /// @post its context is current
  RendererState& GetState(vtkOpenGLRenderer* renderer, vtkOpenGLRenderWindow* window);

  /// Mirrors the scene and draws its lines over what is there.
  /// @param keepsDepth  more will be drawn: what of it is behind a line is hidden by it
  void DrawLines(vtkSilhouettePass* self, const vtkRenderState* s, vtkOpenGLRenderer* renderer,
                 vtkOpenGLRenderWindow* window, bool keepsDepth);

  const shadow::OutlineEffect::Statistics& GetStatistics() const
  {
    static const shadow::OutlineEffect::Statistics none;
    return this->Current != nullptr ? this->Current->Effect.getStatistics() : none;
  }

  vtkSmartPointer<vtkRenderPass> Delegate;
  shadow::ScenePasses Passes;
  shadow::PropExclusions NotOutlined;
  shadow::RendererStates<RendererState> Renderers;
  RendererState* Current = nullptr; ///< of the last rendering
  bool Busy = false;                ///< while rendering or releasing, to notice delegates that lead back here
  bool LedBack = false;             ///< the delegates of the rendering did
  int Status = STATUS_NOT_RENDERED;
  std::string Message;
  std::set<shadow::CasterCuller::Skipped> Skipped;
  double SceneMilliseconds = 0.0;
};

#endif
