#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "Capabilities.h"
#include "CasterCuller.h"
#include "DrawVisitor.h"
#include "DrawableCache.h"
#include "Light.h"
#include "Node.h"
#include "SceneBoundsVisitor.h"
#include "SilhouetteFinder.h"
#include "StencilTarget.h"
#include "View.h"

class vtkOpenGLRenderWindow;
class vtkOpenGLState;
class vtkShaderProgram;

namespace shadow
{

/// Root of the scene graph, and the passes that turn the graph below it into a shadow mask (the thesis's
/// ShadowVolume effect, with the silhouette found on the CPU).
///
/// 1. CasterCuller and SEDVisitor bring volumes up to date
/// 2. pre-pass: depth of all geometry, and which lights its visible side faces
/// 3. for each light: volumes into the stencil, the stencil into the mask
///
/// @par Source  Shi 2006, chapter 4.2; Everitt & Kilgard 2002
class ShadowVolumeEffect : public Group
{
public:
  struct Settings
  {
    StencilMethod stencilMethod = StencilMethod::Auto;
    SilhouetteMethod silhouetteMethod = SilhouetteMethod::Auto;
    int samples = 1;
    bool waitAfterStages = false; ///< so that milliseconds are those of the stage
  };

  struct Statistics
  {
    std::size_t prePassTriangles = 0;
    std::size_t sideTriangles = 0;
    std::size_t capTriangles = 0;
    std::size_t silhouetteEdges = 0;
    int casters = 0;
    int zFailCasters = 0;
    int rebuiltVolumes = 0;
    std::map<SilhouetteMethod, int> usedMethods; ///< casters that each method was used for
    std::set<CasterCuller::Skipped> skipped;
    double silhouetteMilliseconds = 0.0;
    double prePassMilliseconds = 0.0;
    double stencilMilliseconds = 0.0;
  };

  /// Renders the shadow mask.
  ///
  /// @pre   the window's context is current; GL state is put back before this returns
  /// @return false with a line in @p error when the GL cannot; the mask is then not to be used
  bool renderMask(vtkOpenGLRenderWindow* window, const View& view, const std::vector<Light>& lights,
                  const Settings& settings, std::string& error);

  const Statistics& getStatistics() const { return this->statistics; }
  StencilTarget& getTarget() { return this->target; }
  const DepthRange& getDepthRange() const { return this->depthRange; }

  /// Frees the GL objects. @pre their context is current, or is gone and @p contextLost
  void release(bool contextLost);

  /// Bytes on the GPU.
  std::size_t getGraphicsMemorySize() const;

private:
  void face(const View& view, const std::vector<Light>& lights, const Settings& settings,
            const SilhouetteFinder& finder);
  DrawVisitor::Pass makeDrawPass(vtkOpenGLState* state, vtkShaderProgram* program, const View& view);
  bool drawPrePass(vtkOpenGLRenderWindow* window, const View& view);
  bool drawVolumes(vtkOpenGLRenderWindow* window, const View& view, const Light& light);
  void chooseDepthRange(const View& view, const SceneBounds& bounds);

  Capabilities capabilities;
  bool capabilitiesKnown = false;
  StencilTarget target;
  DrawableCache drawables;
  DepthRange depthRange;
  Statistics statistics;
};

} // namespace shadow
