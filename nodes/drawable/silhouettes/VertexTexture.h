#pragma once

#include "EdgePoints.h"
#include "PreparedSilhouette.h"
#include "TexelPainter.h"

namespace shadow
{

/// All vertices in a float texture, each edge a point, its silhouette state for all lights drawn into an edge
/// texture that the sides of volumes are drawn from.
///
/// @par Cost    one facing a triangle and light, two look-ups an edge
/// @par Memory  8 bytes a triangle and 16 an edge, for each path, beside the tables
/// @par Source  Brabec & Seidel 2003, "Shadow Volumes on Programmable Graphics Hardware"; that the facing of
///              a triangle is evaluated once is Shi's (2006, chapter 3.3.3)
class VertexTexture : public PreparedSilhouette
{
public:
  /// Where edges take the facing of their triangles from.
  enum class Normals
  {
    OncePerTriangle,   ///< from a texture of it, drawn first
    PerEdge,           ///< evaluated for each edge anew, by the same function from the same corners
    PerEdgeAsPublished ///< evaluated from the edge's four vertices in its own order, in single precision:
                       ///< edges may disagree on a triangle, and silhouettes are then open. For measurements
                       ///< only
  };

  /// @param maximumSide  see TexelArray
  explicit VertexTexture(Normals normalsFrom = Normals::OncePerTriangle, int maximumSide = 0)
      : normals(normalsFrom), side(maximumSide)
  {
  }

  /// The edge texture of a path. Texel e is edge e of its geometry; bit i of x: light i has the edge on its
  /// silhouette as it runs; of y: the other way; of z: twice.
  /// @pre finishPreparing() has succeeded for it
  const TexelArray& getEdgeTexels(const NodePath& path) const { return this->getPrepared(path).edges; }

  void release(bool contextLost) override;

protected:
  std::unique_ptr<Prepared> makePrepared() const override;
  bool find(const std::vector<Change>& surfaces, std::string& error) override;
  std::string getFacingSwitches() const override;
  void bindFacing(vtkShaderProgram* program, const Surface& surface,
                  const std::vector<Light>& lights) override;
  std::string getSideSwitches() const override { return "#define SHADOW_EDGE_TEXTURE\n"; }
  void bindSilhouette(vtkShaderProgram* program, const Surface& surface, const Light& light) override;

private:
  struct PreparedEdges;
  bool findFacing(const Change& change, std::string& error);
  bool findEdges(const Change& change, std::string& error);

  Normals normals;
  int side;
  TexelPainter painter;
};

} // namespace shadow
