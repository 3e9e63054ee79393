#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "Capabilities.h"
#include "DrawableCache.h"
#include "LargeFaces.h"
#include "LineDrawable.h"
#include "Node.h"
#include "OutlineTarget.h"
#include "SilhouetteFinder.h"
#include "TopologyAwareMesh.h"
#include "View.h"
#include "WindowDepth.h"

class vtkOpenGLRenderWindow;
class vtkOpenGLState;
class vtkShaderProgram;

namespace shadow
{

/// How lines are found and drawn. All give the same picture, but for Faces where the eye is closer to a
/// triangle's plane than 16 bits a coordinate of its normal tell, see packNormal().
enum class LineTechnique
{
  Rectangles, ///< edges found from an exact facing on the CPU, each drawn as a rectangle
  Faces ///< the paper's: every face of the mesh tells its own edges by the normals it stores, and is scaled
        ///< about its incentre until it covers their lines
};

/// As fine as makes lines end where they are hidden (4), less where a target of that size would take too much
/// memory.
int chooseDepthScale(int width, int height);

/// Root of the scene graph, and the passes that turn the graph below it into outlines.
///
/// 1. facing of all triangles towards the eye, exactly, and the edges that are lines
/// 2. pass 1: depth of all geometry and its slope
/// 3. pass 2: the lines, each pixel where the nearest point of an edge is not behind pass 1
///
/// Nodes with Node::casting off have no lines, and hide those of others.
///
/// @par Source  Valient, "Hardware Generated Object Silhouettes"
class OutlineEffect : public Group
{
public:
  struct Settings
  {
    LineTechnique technique = LineTechnique::Rectangles;
    double lineWidth = 2.0; ///< pixels
    bool silhouette = true;
    bool border = true;
    bool crease = false;
    double featureAngle = 60.0;     ///< degrees, of creases
    bool leavesOutFlatFaces = true; ///< Faces: none that can have no line is drawn, see ContributingFaces
    bool splitsLargeFaces = true;   ///< Faces: three thin triangles for one where that covers fewer pixels
    int depthScale = 0; ///< pixels of pass 1 for one of the view, in each direction; 0: chooseDepthScale()
    /// What the bound framebuffer's depth has in front of the graph hides lines, too: where it is nearer by
    /// windowTolerance, in window depth, and by what the depth changes over windowReach pixels.
    bool behindWindow = false;
    double windowTolerance = 1e-6;
    double windowReach = 1.0;
    /// blend() has the framebuffer's depth be that of visible lines, for what comes after, in pixels whose
    /// middle they cover.
    bool keepsDepth = false;
    bool waitAfterStages = false; ///< so that milliseconds are those of the stage
  };

  /// How lines are put over the scene.
  struct Look
  {
    glm::dvec3 color{0.0};
    glm::dvec4 hiddenColor{0.0}; ///< and opacity
    bool smooth = true;
  };

  struct Statistics
  {
    std::size_t depthTriangles = 0;
    std::size_t lineTriangles = 0;
    std::size_t lineEdges = 0;
    double edgeMilliseconds = 0.0;
    double depthMilliseconds = 0.0;
    double lineMilliseconds = 0.0;
    double blendMilliseconds = 0.0;
  };

  /// Draws the lines into a target of the effect's own. Where the window's depth cannot be had, says so in
  /// getErrors().
  ///
  /// @pre   the window's context is current; GL state is put back before this returns
  /// @return false with a line in @p error when the GL cannot; there are then no lines
  bool renderLines(vtkOpenGLRenderWindow* window, const View& view, const Settings& settings,
                   std::string& error);

  /// Blends the lines over the bound framebuffer, in the viewport that is set.
  /// @return as renderLines()
  bool blend(vtkOpenGLRenderWindow* window, const Look& look, bool wait, std::string& error);

  /// What the GL cannot do for lines, one line each: a mesh too large, a window's depth that cannot be had.
  const std::vector<std::string>& getErrors() const { return this->errors; }

  const Statistics& getStatistics() const { return this->statistics; }

  /// Columns and rows of the view that lines were rendered for last; 0 when there is none.
  std::array<int, 2> getSize() const;

  /// 255 for each pixel of the view that visible lines cover, else 0; bottom row first.
  std::vector<unsigned char> readMask(vtkOpenGLRenderWindow* window) const;

  /// Frees the GL objects. @pre their context is current, or is gone and @p contextLost
  void release(bool contextLost);

  /// Bytes on the GPU.
  std::size_t getGraphicsMemorySize() const;

private:
  /// What is kept for one way to a mesh.
  struct PathLines
  {
    std::weak_ptr<const SEDGeometry> geometry;
    std::shared_ptr<const TopologyAwareMesh> mesh;
    glm::dvec4 eyeMC{0.0};
    Settings settings;
    LightFacing facing;
    std::vector<FaceEdges> creases;
    std::vector<FaceEdges> lines;
    LineDrawable drawable;
    LargeFaces largeFaces;
    bool found = false;    ///< lines belong to eyeMC and settings
    bool uploaded = false; ///< the GL has taken them
    bool used = false;
  };

  /// One way to a mesh, as it is drawn in this frame.
  struct Surface
  {
    std::string name;
    std::shared_ptr<const SEDGeometry> geometry;
    glm::dmat4 wcFromMC{1.0}; ///< from positions relative to the geometry's origin
    FaceCulling culling = FaceCulling::None;
    PathLines* lines = nullptr; ///< none when it has none
    glm::dvec4 eyeMC{0.0};
  };
  class SurfaceCollector;

  static constexpr const char* noShader = "a shader of the outlines does not compile on this GL";
  static constexpr const char* keptDepth = "#define SHADOW_LINE_DEPTH\n";
  static constexpr double softness = 0.5; ///< pixels by which a line is drawn beyond its half width

  bool drawStages(vtkOpenGLRenderWindow* window, const View& view, const Settings& settings,
                  std::string& error);
  void findLines(const Surface& surface, const Settings& settings);
  void findLinesAnew(PathLines& kept, const SEDGeometry& geometry, const glm::dvec4& eyeMC,
                     const Settings& settings, bool sameCreases);
  static void findMesh(const Surface& surface);
  bool drawDepth(vtkOpenGLRenderWindow* window, const View& wideView, std::string& error);
  bool drawLines(vtkOpenGLRenderWindow* window, const View& wideView, const Settings& settings,
                 std::string& error);
  bool drawLinesOf(const Surface& surface, vtkOpenGLState* state, vtkShaderProgram* program);
  bool drawFacesOf(const Surface& surface, vtkOpenGLState* state, vtkShaderProgram* program,
                   const View& wideView, const Settings& settings);
  void chooseDepthRange(const View& view);

  std::unique_ptr<SilhouetteFinder> finder;
  Capabilities capabilities;
  bool capabilitiesKnown = false;
  OutlineTarget target;
  WindowDepth windowDepth;
  bool keepsDepth = false;       ///< Settings::keepsDepth of the lines that were rendered last
  glm::vec2 depthToWindow{0.0f}; ///< windowFromDepth() of these
  DrawableCache drawables;
  DepthRange depthRange;
  int margin = 0; ///< pixels by which the target is wider than the view, on each side
  std::vector<Surface> surfaces;
  std::map<NodePath, PathLines> paths;
  std::vector<std::string> errors;
  Statistics statistics;
};

} // namespace shadow
