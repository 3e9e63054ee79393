#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "GPUSilhouette.h"
#include "Light.h"
#include "NodeVisitor.h"
#include "SEDGeode.h"

namespace shadow
{

/// Hands every SEDGeode to a method that finds silhouettes on the GPU, in the mode that the SVStateVisitor
/// has set, or to be prepared.
class GPUSilhouetteVisitor : public NodeVisitor
{
public:
  enum class Stage
  {
    Prepare, ///< lights in model space; what the method has to do before it draws. The CasterCuller was here
    Draw
  };

  /// Triangles handed to the GL, whether or not they have an area; the most it may be where the GPU itself
  /// decides how many.
  struct Counts
  {
    std::size_t geometry = 0;
    std::size_t sides = 0;
    std::size_t caps = 0;
  };

  GPUSilhouetteVisitor(Stage theStage, GPUSilhouette& theMethod, const std::vector<Light>& theLights)
      : stage(theStage), method(theMethod), lights(theLights)
  {
  }

  using NodeVisitor::apply;
  void apply(SEDGeode& geode) override;

  const Counts& getCounts() const { return this->counts; }
  bool hasDrawn() const { return this->drawn; } ///< something was counted

  /// One line when the GL could not do what was asked; empty otherwise.
  const std::string& getError() const { return this->error; }

private:
  void prepare(SEDGeode& geode, PathState& path);
  void draw(const SEDGeode& geode, const PathState& path);
  GPUSilhouette::Surface describe(const SEDGeode& geode, const PathState& path) const;

  Stage stage;
  GPUSilhouette& method;
  const std::vector<Light>& lights;
  Counts counts;
  bool drawn = false;
  std::string error;
};

} // namespace shadow
