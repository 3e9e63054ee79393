#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include <glm/glm.hpp>

#include "GPUFacingBound.h"
#include "Light.h"
#include "Node.h"
#include "NodeVisitor.h"
#include "SEDGeometry.h"
#include "ShadowVolume.h"

namespace shadow
{

/// How a caster's volume for one light is counted.
enum class StencilCount
{
  Skip, ///< not at all
  ZPass,
  ZFail
};

/// What the caster culler decided for one path and light.
struct CasterPlan
{
  StencilCount count = StencilCount::Skip;
  bool lightCap = false;
  DarkCap darkCap = DarkCap::None;
  glm::dvec4 farPlaneWC{0.0, 0.0, 0.0,
                        1.0};       ///< where the volume ends, in world space; as it stands: at infinity
  const char* skipReason = nullptr; ///< set when the caster could have cast and was left out

  bool isFarAtInfinity() const { return this->farPlaneWC == glm::dvec4(0.0, 0.0, 0.0, 1.0); }

  /// The same faces will do.
  bool hasFacesOf(const CasterPlan& other) const
  {
    return this->lightCap == other.lightCap && this->darkCap == other.darkCap &&
           this->isFarAtInfinity() == other.isFarAtInfinity();
  }
};

/// Everything a geode keeps for one path and one light.
struct PathLightState
{
  glm::dvec4 lightMC{0.0};    ///< relative to the geometry's origin; what facing and volume were built for
  bool faced = false;         ///< facing belongs to lightMC
  bool extruded = false;      ///< volumes belong to lightMC and plan
  CasterPlan plan;            ///< for the coming draw
  CasterPlan extrudedPlan;    ///< what volumes were built for
  std::uint64_t finderId = 0; ///< SilhouetteFinder::getId() of whose silhouettes volumes were built from
  /// See ExactVolumeVisitor; of lightMC, not known where nobody asked.
  std::optional<bool> needsExactVolumes;
  GPUFacingBound facingBound; ///< with which that was found out
  LightFacing facing;
  std::size_t extrudedCountable = 0; ///< see ShadowVolumeOptions::countable; what volumes were built for
  std::vector<ShadowVolume> volumes; ///< one; more when a ray could enter it more often than can be counted
  std::uint64_t revision = 0;        ///< another value whenever volumes changed; unique over all geodes
};

/// A side of a path's triangles that the pre-pass marks in the shadow mask.
struct MarkedSide
{
  std::uint32_t bit = 0;   ///< of the mask, cleared where the side is seen; 0: no side is marked
  bool inputFront = false; ///< the side that is the front as the input is wound; false: its back

  bool operator==(const MarkedSide& other) const
  {
    return this->bit == other.bit && (this->bit == 0 || this->inputFront == other.inputFront);
  }
};

/// Everything a geode keeps for one path: its volumes, and the facing of each triangle for all lights.
struct PathState
{
  glm::dmat4 modelToWorld{1.0};
  std::map<int, PathLightState> lights; ///< by Light::index
  std::vector<glm::uvec2>
      reachableBits; ///< a triangle: x raster-front, y raster-back; bit i: that side faces light i
  FaceCulling hiddenSide = FaceCulling::None; ///< no pixel of the coming pre-pass would show it
  MarkedSide marked;                          ///< for the coming pre-pass
  MarkedSide reachableMarked;                 ///< what reachableBits have
  std::uint64_t reachableRevision = 0;        ///< another value whenever reachableBits changed
  bool inView = true; ///< the geometry may be seen, so that facing is wanted for the pre-pass
  bool batched = false; ///< drawn together with others, see SurfaceBatch, in the coming passes
  bool used = false;  ///< met since the last call of dropUnusedPaths()
};

/// What a geode draws in the coming pass.
struct RenderMode
{
  enum class What
  {
    Geometry,
    Volume
  };
  What what = What::Geometry;
  int light = 0;                            ///< Light::index, for Volume
  StencilCount count = StencilCount::ZPass; ///< only volumes that are counted this way, for Volume
};

/// Leaf with a mesh and its adjacency. Shared by any number of parents, it keeps the volumes of each path and
/// light.
///
/// @par Source  Shi 2006, chapter 4.2.2 and figure 4.2
class SEDGeode : public Node
{
public:
  explicit SEDGeode(std::shared_ptr<const SEDGeometry> sedGeometry) : geometry(std::move(sedGeometry)) {}

  void accept(NodeVisitor& visitor) override;

  const SEDGeometry& getGeometry() const { return *this->geometry; }
  const std::shared_ptr<const SEDGeometry>& getSharedGeometry() const { return this->geometry; }

  /// What is kept for a path; made when it is not there.
  PathState& getPathState(const NodePath& path);

  const std::map<NodePath, PathState>& getPathStates() const { return this->paths; }

  /// Forgets paths that getPathState() has not been asked for since the last call.
  void dropUnusedPaths();

  /// Volumes kept over all paths and lights.
  std::size_t countVolumes() const;

  /// Bytes kept over all paths and lights, without the geometry.
  std::size_t getMemorySize() const;

  RenderMode renderMode;

private:
  std::shared_ptr<const SEDGeometry> geometry;
  std::map<NodePath, PathState> paths;
};

/// Corners of a box; [0] and [7] are opposite.
using BoxCorners = std::array<glm::dvec3, 8>;

/// World-space corners of a geometry's bounding box.
BoxCorners worldCorners(const SEDGeometry& geometry, const glm::dmat4& modelToWorld);

/// World space from positions relative to a geometry's origin.
glm::dmat4 worldFromRelative(const SEDGeometry& geometry, const glm::dmat4& modelToWorld);

/// A plane in world space as positions relative to a geometry's origin see it, scaled so that floats hold it.
glm::dvec4 farPlaneToModel(const glm::dvec4& planeWC, const glm::dmat4& wcFromRelative);

/// False for a matrix that flattens, or that is not finite.
bool isInvertible(const glm::dmat4& modelToWorld);

/// A light as a geometry under @p modelToWorld sees it, relative to the geometry's origin.
/// Nothing when the matrix cannot be inverted.
std::optional<glm::dvec4> lightToModel(const Light& light, const glm::dmat4& modelToWorld,
                                       const glm::dvec3& origin);

} // namespace shadow
