#ifndef ShadowPassInternals_h
#define ShadowPassInternals_h

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include <vtkTimeStamp.h>

#include "LightCollector.h"
#include "LightTarget.h"
#include "LightingHook.h"
#include "PassContext.h"
#include "SceneBuilder.h"
#include "ScenePasses.h"
#include "ShadowVolumeEffect.h"
#include "View.h"
#include "vtkShadowVolumePass.h"

/// What vtkShadowVolumePass keeps out of its header.
class vtkShadowVolumePass::vtkInternals
{
public:
  /// Everything that belongs to one renderer: a pass may serve several.
  struct RendererState
  {
    shadow::PassContext Context;
    shadow::SceneBuilder Builder;
    std::shared_ptr<shadow::ShadowVolumeEffect> Effect = std::make_shared<shadow::ShadowVolumeEffect>();
    shadow::LightTarget Lights; ///< Additive only
    shadow::View View;
    shadow::MessageFilter Messages;

    RendererState(vtkOpenGLRenderer* renderer, vtkOpenGLRenderWindow* window) : Context(renderer, window) {}
    ~RendererState();

    /// What a refusal is of: another setting, or another kind of view, may be drawn rightly.
    struct Way
    {
      int method = -1;
      int countBuffer = 0;
      int samples = 0;
      bool parallel = false;

      bool operator!=(const Way& other) const
      {
        return this->method != other.method || this->countBuffer != other.countBuffer ||
               this->samples != other.samples || this->parallel != other.parallel;
      }
    };
    Way Wanted; ///< what Refusals and RefusedSamples belong to

    /// What a method had to give way for: as many as the GL has turned out to be unable to do since what is
    /// wanted or the context changed.
    std::map<shadow::SilhouetteMethod, std::string> Refusals;

    vtkTimeStamp ShaderTime;              ///< when the text put into VTK's shaders changed last
    std::set<std::string> ShaderMessages; ///< of shaders that have been built since
    int ShaderSamples = 0;                ///< of the mask, in that text
    int RefusedSamples = 0;               ///< of the mask, that the GL could not do; 0: none

    /// Forgets what was refused where something else was wanted.
    void Want(const Way& wanted);

    /// The method to use for the one that is wanted: that, or the next best that the GL can do.
    /// @param note  one line when it is not the wanted one
    shadow::SilhouetteMethod ChooseMethod(int wanted, int samples, std::string& note);

    /// Has the effect that a silhouette method needs.
    void ChooseEffect(shadow::SilhouetteMethod method);

    /// Whether the effect draws right in this context. Where it does so only without Batches, or with another
    /// count buffer than the one in @p settings, and may, it gets that.
    /// @param note  one line more when it does
    /// @param fault  one line when nothing is right
    /// @pre   ChooseEffect()
    bool CheckEffect(shadow::ShadowVolumeEffect::Settings& settings, std::string& note, std::string& fault);
    double CheckMilliseconds = 0.0; ///< added up by CheckEffect()

    /// @post the context is current, and GL objects of a context that is gone are forgotten
    void Acquire();
    void Release();
    std::size_t GetMemorySize() const
    {
      return this->Builder.getMemorySize() + this->Effect->getGraphicsMemorySize() +
             this->Lights.getMemorySize();
    }
  };

  /// Brings the scene graph up to date and renders the shadow mask. @return false when there can be no
  /// shadows
  bool PrepareMask(vtkShadowVolumePass* self, const vtkRenderState* s, vtkOpenGLRenderer* renderer,
                   vtkOpenGLRenderWindow* window);

  /// Of the last rendering; all zero before the first.
  const shadow::ShadowVolumeEffect::Statistics& GetStatistics() const;

  /// Has the GL leave out triangles of a prop that is about to be drawn, if no pixel shows them.
  void SetHiddenSide(vtkProp* prop);

  /// Makes ready for adding lights one by one, to what @p opaque has drawn.
  /// @return false, with a message, when that cannot be
  bool BeginLights(const vtkRenderPass* opaque);

  /// Draws what each light adds to the picture of AmbientOnly, and adds it.
  void AddLights(const vtkRenderState* s, vtkRenderPass* opaque);

  /// Has a prop that is about to be drawn show where it does in the picture: of surfaces that coincide one.
  /// Does nothing but in a lighting pass.
  /// @param addsLight  its shader tells what the light adds; others add nothing where they show
  void BlendLight(bool addsLight);

  void Release(vtkWindow* window);
  void AddMessage(const std::string& message); ///< of something left out
  void AddNote(const std::string& note);       ///< of something that leaves the picture as it should be

  shadow::ScenePasses Passes;
  shadow::PropExclusions NotCasting;

  std::function<void()> AfterOpaque; ///< called once what is opaque has been drawn

  shadow::LightingHook Hook;
  shadow::RendererStates<RendererState> Renderers;
  RendererState* Current = nullptr; ///< of the last rendering

  std::set<vtkProp*> Drawn; ///< of the last rendering; only to be compared with
  int Status = STATUS_NOT_RENDERED;
  std::string Message;
  std::string Remark; ///< what may be meant to be so: told to who asks, and no warning
  std::set<shadow::CasterCuller::Skipped> Skipped;
  /// Props of the last rendering that no pixel shows the back of, and what has to be culled for it.
  std::map<vtkProp*, shadow::FaceCulling> HiddenBacks;
  int ShadowLights = 0;
  int UsedMethod = -1; ///< SilhouetteMethods; none before the first rendering
  int LightingPasses = 0;
  bool FirstShows = false; ///< of surfaces that coincide, the one that VTK draws first; else the last
  double SceneMilliseconds = 0.0;
  double LightingMilliseconds = 0.0;

private:
  RendererState& GetState(vtkOpenGLRenderer* renderer, vtkOpenGLRenderWindow* window);
  void UpdateScene(vtkShadowVolumePass* self, RendererState& state);
  bool RenderMask(vtkShadowVolumePass* self, RendererState& state, const shadow::LightList& lights);

  /// Samples a pixel of the mask: those that are set, or as many as what is drawn into has.
  int ChooseSamples(int wanted, const RendererState& state);

  void CollectHiddenBacks(const RendererState& state);
};

#endif
