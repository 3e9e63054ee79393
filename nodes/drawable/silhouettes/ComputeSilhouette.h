#pragma once

#include "ComputeProgram.h"
#include "PreparedSilhouette.h"

namespace shadow
{

/// Compute shaders find the facing of all triangles and gather the edges on the silhouette of each light in a
/// list; the sides of volumes are drawn from the list, as many as the GPU has counted. Nothing is read back.
///
/// Beyond the papers: what they draw for every edge, most of it without an area, is drawn here for the edges
/// on the silhouette alone.
///
/// @pre         GL 4.3
/// @par Cost    one facing a triangle and light, two look-ups an edge; O(silhouette) vertices
/// @par Memory  for each path 8 bytes a triangle and, for each light, 4 bytes an edge, beside the tables
class ComputeSilhouette : public PreparedSilhouette
{
public:
  /// @param mostGroups   see ComputeProgram
  /// @param maximumSide  see TexelArray
  explicit ComputeSilhouette(int mostGroups = 0, int maximumSide = 0);

  /// What is listed for the lights of a path.
  struct Lists
  {
    const TexelArray* entries; ///< see shaders/silhouette.comp; list n starts at texel n times edges
    unsigned int commands;     ///< a buffer with two EdgeQuads::Command a list
  };

  /// @pre finishPreparing() has succeeded for the path
  Lists getLists(const NodePath& path) const;

  void release(bool contextLost) override;

protected:
  std::unique_ptr<Prepared> makePrepared() const override;
  bool find(const std::vector<Change>& surfaces, std::string& error) override;
  std::string getSideSwitches() const override { return "#define SHADOW_SILHOUETTE_LIST\n"; }
  void bindSilhouette(vtkShaderProgram* program, const Surface& surface, const Light& light) override;
  void drawQuads(EdgeQuads& edgeQuads, const Surface& surface, const Light& light, bool fan) override;

private:
  struct PreparedLists;
  bool findFacing(const Change& change, std::string& error);
  bool findLists(const Change& change, std::string& error);
  std::size_t getList(const Surface& surface, const Light& light) const;

  int side;
  ComputeProgram facingProgram;
  ComputeProgram listProgram;
};

} // namespace shadow
