#pragma once

#include "EdgeQuads.h"
#include "GPUSilhouette.h"

namespace shadow
{

/// Every edge is a quad, and the vertex shader gives an area to those on the silhouette.
///
/// The facing of an edge's triangles is evaluated where it is asked for, from the same corners in the same
/// order, and so always the same: vertex extrusion. Subclasses take it from elsewhere.
///
/// @par Cost    O(edges) vertices a light and caster, whatever the silhouette
/// @par Source  McGuire & Hughes 2004, "Hardware-Determined Feature Edges"; Wallner 2006
class EdgeQuadSilhouette : public GPUSilhouette
{
public:
  void release(bool contextLost) override;
  std::size_t getMemorySize() const override;

protected:
  bool drawSides(const Surface& surface, const Light& light, StencilCount count, bool fan) override;

  /// Lines of the preprocessor that choose where shaders/silhouetteSource.glsl takes the silhouette from.
  virtual std::string getSideSwitches() const { return ""; }

  /// Gives the program what silhouetteSource.glsl asks for. @pre the program is current
  virtual void bindSilhouette(vtkShaderProgram* /*program*/, const Surface& /*surface*/,
                              const Light& /*light*/)
  {
  }

  /// Draws the quads of a surface and light with the current program.
  virtual void drawQuads(EdgeQuads& edgeQuads, const Surface& surface, const Light& light, bool fan);

private:
  EdgeQuads quads;
};

} // namespace shadow
