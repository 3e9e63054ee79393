#pragma once

#include <cstddef>
#include <functional>
#include <utility>

#include <glm/glm.hpp>

#include "DrawableCache.h"
#include "FaceCounter.h"
#include "NodeVisitor.h"
#include "SEDGeode.h"
#include "ShadowPrograms.h"
#include "View.h"

class vtkOpenGLState;
class vtkShaderProgram;

namespace shadow
{

/// Draws every SEDGeode that is in no batch in the mode that the SVStateVisitor has set.
class DrawVisitor : public NodeVisitor
{
public:
  /// Triangles, those of volumes as often as they count.
  struct Counts
  {
    std::size_t geometry = 0;
    std::size_t sides = 0;
    std::size_t caps = 0;
    std::size_t silhouetteEdges = 0;
  };

  /// What one pass over the graph draws with.
  struct Pass
  {
    vtkOpenGLState* state = nullptr;
    vtkShaderProgram* program = nullptr;
    DrawableCache* drawables = nullptr;
    const View* view = nullptr;
    glm::dmat4 clipFromWC{1.0};                     ///< with the depth row of the shadow stages
    bool reversedDepth = true;                      ///< see DepthRange
    CountBuffer countBuffer = CountBuffer::Stencil; ///< for volumes
    std::function<void(std::size_t)> makeRoom;      ///< called before a volume with its overlap bound
  };

  explicit DrawVisitor(Pass thePass) : pass(std::move(thePass)) {}

  using NodeVisitor::apply;
  void apply(SEDGeode& geode) override;

  const Counts& getCounts() const { return this->counts; }

private:
  bool setMatrices(const glm::dmat4& wcFromMC);
  void drawGeometry(const SEDGeode& geode, const PathState& path);
  void drawVolumes(const SEDGeode& geode, const PathLightState& light, StencilCount count);

  Pass pass;
  Counts counts;
};

} // namespace shadow
