#pragma once

#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include "LargeMeshVisitor.h"

class vtkOpenGLState;

namespace shadow
{

class ShadowPrograms;
class ShadowTarget;
struct View;

/// Finds out which large meshes show the camera none of their backs, so that these need not be drawn.
///
/// Triangles seen from behind lie behind others of their mesh nearly always, but not where a mesh is open,
/// cut by the near plane or inside out. The pre-pass therefore marks the pixels whose surface is such a back,
/// in a bit of the shadow mask that no light has, and an occlusion query looks for marks. The lighting of the
/// same rendering leaves hidden backs out, and so does the next pre-pass when nothing in view has moved.
///
/// Worth it where each triangle costs, which is on a software GL: half of a mesh's triangles against one
/// sweep over the pixels.
class HiddenBacks
{
public:
  /// Fewer triangles than this cost less than the sweep.
  static constexpr std::size_t fewestTriangles = 10000;

  HiddenBacks() = default;
  HiddenBacks(const HiddenBacks&) = delete;
  HiddenBacks& operator=(const HiddenBacks&) = delete;

  /// Starts a rendering, of which nothing is known.
  void begin();

  /// Has the pre-pass mark the largest meshes of a graph, as many as there are bits; or, when it would draw
  /// what it drew the last time, leave out what is hidden.
  /// @param clipFromWC  see shadowClipFromWC()
  /// @param taken       bits of the mask that lights have; all of them where nothing shall be left out
  void choose(Group& root, const View& view, const glm::dmat4& clipFromWC, std::uint32_t taken);

  /// Has the GL look for marks. @pre the pre-pass has been drawn. Leaves another framebuffer bound
  void ask(vtkOpenGLState* state, ShadowPrograms& programs, ShadowTarget& target);

  /// Waits for the GL's answers.
  void fetch();

  /// Meshes that show no back, after fetch().
  const std::vector<LargeMesh>& getHidden() const { return this->hidden; }

  /// Frees the GL objects. @pre their context is current, or is gone and @p contextLost
  void release(bool contextLost);

private:
  struct Watched
  {
    LargeMesh mesh;
    std::uint32_t bit = 0;
    bool asked = false;
  };

  /// What the answers depend on.
  struct Shown
  {
    std::vector<ShownSurface> surfaces;
    glm::dmat4 clipFromWC{0.0};
    int width = 0;
    int height = 0;

    bool operator==(const Shown& other) const
    {
      return this->surfaces == other.surfaces && this->clipFromWC == other.clipFromWC &&
             this->width == other.width && this->height == other.height;
    }
  };

  void mark(std::vector<LargeMesh> meshes, std::uint32_t taken);

  static constexpr std::size_t most = 4; ///< meshes, each takes a sweep

  std::vector<Watched> watched;
  std::vector<LargeMesh> hidden;
  Shown shown;                       ///< what hiddenIn belongs to
  std::vector<NodePath> hiddenIn;    ///< paths that showed no back
  std::vector<unsigned int> queries; ///< [i] of watched[i]
};

} // namespace shadow
