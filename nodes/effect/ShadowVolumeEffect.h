#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "BatchCollector.h"
#include "Capabilities.h"
#include "CasterCuller.h"
#include "DrawVisitor.h"
#include "DrawableCache.h"
#include "FaceCounter.h"
#include "HiddenBacks.h"
#include "KeptBits.h"
#include "Light.h"
#include "MaskInputs.h"
#include "Node.h"
#include "Savings.h"
#include "SceneBoundsVisitor.h"
#include "ScreenRectangle.h"
#include "ShadowTarget.h"
#include "SilhouetteFinder.h"
#include "SurfaceBatch.h"
#include "View.h"
#include "VolumeBatch.h"

class vtkOpenGLRenderWindow;
class vtkOpenGLState;
class vtkShaderProgram;

namespace shadow
{

class CountedFolds;

/// Root of the scene graph, and the passes that turn the graph below it into a shadow mask (the thesis's
/// ShadowVolume effect, with the silhouette found on the CPU).
///
/// 1. CasterCuller and SEDVisitor bring volumes up to date
/// 2. pre-pass: depth of all geometry, and which lights its visible side faces
/// 3. for each light: the faces of its volumes counted, what the count is not zero for taken out of the mask
///
/// @par Source  Shi 2006, chapter 4.2; Everitt & Kilgard 2002
class ShadowVolumeEffect : public Group
{
public:
  struct Settings
  {
    StencilMethod stencilMethod = StencilMethod::Auto;
    SilhouetteMethod silhouetteMethod = SilhouetteMethod::Auto;
    CountBuffer countBuffer = CountBuffer::Auto;
    double coplanarTolerance = 0.0; ///< degrees, see makeSilhouetteFinder()
    int samples = 1;
    int savings = AllSavings;     ///< flags, see Savings
    bool findHiddenBacks = true;  ///< where it pays, see HiddenBacks
    bool waitAfterStages = false; ///< so that milliseconds are those of the stage
  };

  /// Of volumes.
  struct VolumeCounts
  {
    std::size_t sideTriangles = 0;
    std::size_t capTriangles = 0;
    std::size_t silhouetteEdges = 0;
  };

  /// Of the mask as it is, whether the last rendering made it or kept it; times, rebuilt volumes and kept lights
  /// of the last rendering.
  struct Statistics : VolumeCounts
  {
    std::size_t prePassTriangles = 0;
    std::size_t countedPixels = 0; ///< that volumes are counted in, for each light
    int keptLights = 0; ///< whose part of the mask was there already
    std::size_t batchedSurfaces = 0; ///< meshes that were drawn together, counted once for each path
    int casters = 0;
    int zFailCasters = 0;
    int rebuiltVolumes = 0;
    std::map<SilhouetteMethod, int> usedMethods; ///< casters that each method was used for
    std::set<CasterCuller::Skipped> skipped;
    double silhouetteMilliseconds = 0.0;
    double prePassMilliseconds = 0.0;
    double stencilMilliseconds = 0.0;
    double readBackMilliseconds = 0.0; ///< of silhouetteMilliseconds: copying from the GPU and waiting for it
  };

  /// What the current context can do. @pre a context is current, always the same until release()
  const Capabilities& getCapabilities();

  /// The buffer that volumes are counted in. @pre getCapabilities() has been called
  virtual CountBuffer chooseCountBuffer(CountBuffer wanted, int samples) const;

  /// Renders the shadow mask, or has what is there already, see Settings::savings.
  ///
  /// @pre   the window's context is current; GL state is put back before this returns
  /// @return false with a line in @p error when the GL cannot; the mask is then not to be used
  bool renderMask(vtkOpenGLRenderWindow* window, const View& view, const std::vector<Light>& lights,
                  const Settings& settings, std::string& error);

  const Statistics& getStatistics() const { return this->statistics; }
  void clearStatistics() { this->statistics = {}; }
  ShadowTarget& getTarget() { return this->target; }
  const DepthRange& getDepthRange() const { return this->depthRange; }

  /// Meshes that are known to show the camera no back in this rendering.
  const std::vector<LargeMesh>& getHiddenBacks() const { return this->hiddenBacks.getHidden(); }

  /// Frees the GL objects. @pre their context is current, or is gone and @p contextLost
  virtual void release(bool contextLost);

  /// Bytes on the GPU.
  virtual std::size_t getGraphicsMemorySize() const;

protected:
  /// What one mask is rendered for.
  struct Frame
  {
    vtkOpenGLRenderWindow* window;
    const View& view;
    const std::vector<Light>& lights;
    const Settings& settings;
  };

  /// Which lights the triangles face; before the pre-pass. @return false with a line in @p error when it
  /// cannot be done
  virtual bool findFacing(const Frame& frame, std::string& error);

  /// Draws all surfaces. @pre GL is set up for the pre-pass. @return as findFacing()
  virtual bool drawSurfaces(const Frame& frame, std::string& error);

  /// Volumes of all casters, while the GL works on the pre-pass. @return as findFacing()
  virtual bool findSilhouettes(const Frame& frame, std::string& error);

  /// Counts the volumes for one light and takes what they cover out of the mask. @return as findFacing()
  virtual bool drawVolumes(const Frame& frame, const Light& light, std::string& error);

  /// Volumes from the facing that every SEDGeode has.
  void extrude(const Frame& frame, const SilhouetteFinder& silhouetteFinder);

  DrawVisitor::Pass makeDrawPass(vtkShaderProgram* program, const Frame& frame);

  /// The view's clip matrix with this frame's depth range.
  glm::dmat4 getClipFromWC(const View& view) const { return shadowClipFromWC(view, this->depthRange); }

  static constexpr const char* unusableShader = "a shader of the shadow stages does not compile on this GL";

  /// Pixels that volumes are counted in.
  const ScreenRectangle& getCounted() const { return this->counted; }

  DrawableCache& getDrawables() { return this->drawables; }
  Statistics& changeStatistics() { return this->statistics; }

private:
  MaskInputs collectInputs(const Frame& frame, int samples);
  /// Finds out what of the mask before is still right. @return whether all of it is
  bool keepMask(const Frame& frame, int samples);
  void putMaskAside(vtkOpenGLState* state);
  bool countVolumes(const Frame& frame, std::string& error);
  void cull(const Frame& frame);
  void chooseFinder(const Settings& settings);
  bool drawStages(const Frame& frame, std::string& error);
  bool drawPrePass(const Frame& frame, std::string& error);
  void markBacks(const Frame& frame);
  void gatherBatch(const Frame& frame);
  bool drawBatchedSurfaces(const Frame& frame);
  bool drawVolumesAlone(const Frame& frame, const Light& light, StencilCount count, CountedFolds& folds);
  bool drawBatchedVolumes(const Frame& frame, const Light& light, StencilCount count, CountedFolds& folds);
  void dropUnusedBatches(const std::vector<Light>& lights);
  void releaseBatches(bool contextLost);
  std::size_t getBatchMemorySize() const;
  void chooseDepthRange(const View& view, const SceneBounds& bounds);

  std::unique_ptr<SilhouetteFinder> finder; ///< kept while its settings are, and volumes with it
  SilhouetteMethod finderMethod = SilhouetteMethod::Auto;
  double finderTolerance = 0.0;
  Capabilities capabilities;
  bool capabilitiesKnown = false;
  ShadowTarget target;
  int viewSamples = 0;                            ///< a pixel of the framebuffer that VTK draws into
  CountBuffer countBuffer = CountBuffer::Stencil; ///< of the coming frame
  DrawableCache drawables;
  BatchCollector batchCollector;
  SurfaceBatch batch;
  std::map<std::pair<int, StencilCount>, VolumeBatch> volumeBatches; ///< by Light::index
  DepthRange depthRange;
  ScreenRectangle counted;
  HiddenBacks hiddenBacks;
  Statistics statistics;
  std::optional<MaskInputs> madeFrom;        ///< of the mask; nothing where there is none to be kept
  KeptBits kept;                             ///< of the coming frame
  std::map<int, VolumeCounts> countsOfLight; ///< of the mask, by Light::index
};

} // namespace shadow
