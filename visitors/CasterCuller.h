#pragma once

#include <array>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "Light.h"
#include "NodeVisitor.h"
#include "SEDGeode.h"
#include "SceneBoundsVisitor.h"
#include "ScreenRectangle.h"
#include "View.h"

namespace shadow
{

/// What the user wants the stencil to count.
enum class StencilMethod
{
  Auto,
  ZPass,
  ZFail
};

/// Asks of each caster and light: can its shadow be seen, must it be counted by z-pass or z-fail, and with
/// which caps?
///
/// Every answer is conservative, from bounding boxes: a caster is left out, and z-pass is chosen, only where
/// that is sure to be right. Z-pass fails only when the caster's shadow covers a part of the near rectangle,
/// that is when the caster meets the volume between near rectangle and light.
///
/// @par Source  Everitt & Kilgard 2002 ("near-clip volume"); Lengyel 2002
class CasterCuller : public NodeVisitor
{
public:
  struct Skipped
  {
    std::string name;
    std::string reason;
    bool operator<(const Skipped& other) const
    {
      return this->name != other.name ? this->name < other.name : this->reason < other.reason;
    }
  };

  CasterCuller(const View& theView, const std::vector<Light>& theLights, const SceneBounds& bounds,
               StencilMethod theMethod);

  using NodeVisitor::apply;
  void apply(SEDGeode& geode) override;

  const std::set<Skipped>& getSkipped() const { return this->skipped; }
  int getCasters() const { return this->casters; } ///< counted once for each path and light
  int getZFailCasters() const { return this->zFailCasters; }

  /// Pixels that show a surface, and some around them.
  const ScreenRectangle& getReceivers() const { return this->receivers; }

private:
  CasterPlan plan(std::size_t lightPlace, const BoxCorners& corners, bool inFrustum) const;
  bool nothingBehind(const SEDGeometry& geometry, const glm::dmat4& wcFromModel, const Light& light) const;
  std::optional<glm::dvec4> chooseSceneEnd(const Light& light, const BoxCorners& corners,
                                           StencilCount count) const;
  glm::dvec4 endOfParallelView(const Light& light) const;

  const View& view;
  const std::vector<Light>& lights;
  StencilMethod method;
  SceneBounds sceneBounds;
  std::array<glm::dvec4, 6> scenePlanes; ///< just outside the scene's bounding box, inside positive
  std::vector<std::vector<glm::dvec4>> nearVolumes; ///< a light: planes around near rectangle and light
  std::set<Skipped> skipped;
  ScreenRectangle receivers;
  int casters = 0;
  int zFailCasters = 0;
};

} // namespace shadow
