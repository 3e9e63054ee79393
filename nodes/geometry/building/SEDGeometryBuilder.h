#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "SEDGeometry.h"

namespace shadow
{

/// Carries one soup through the stages of buildSEDGeometry().
class SEDGeometryBuilder
{
public:
  explicit SEDGeometryBuilder(const SEDGeometryOptions& optionsIn) : options(optionsIn) {}

  /// See buildSEDGeometry(). To be called once.
  std::optional<SEDGeometry> build(TriangleSoup soup, std::string& error);

private:
  /// @name Stages, in the order in which they run
  /// @{
  bool findUsedPoints(const TriangleSoup& soup, std::string& error);
  bool chooseOrigin(const TriangleSoup& soup, std::string& error);
  bool weldCorners(TriangleSoup& soup, std::string& error);
  void orderTriangles();
  void setCopiesApart(const std::vector<std::uint8_t>& copies);
  void connect();
  bool connectManifold();
  void split();
  void connectOneByOne();
  void countEdgesAndBounds();
  void computePlanes();
  void makeClusters();
  void findCommonPlane();
  void identify();
  /// @}

  bool hasTrianglesOf(const SEDGeometry& other) const;
  bool isConnectedAs(const SEDGeometry& other) const;
  bool isMoved(const SEDGeometry& other) const;
  /// What is known of all triangles once each is finished.
  struct PlaneTotals
  {
    std::size_t zeroArea = 0;
    double sharpness = 0.0;
  };
  void finishTriangle(std::uint32_t triangle, PlaneTotals& totals);

  SEDGeometryOptions options;
  SEDGeometry geometry;
  bool hasPreviousOrder = false; ///< triangles stand as in options.previous
  bool hasPreviousEdges = false; ///< and are connected alike
  std::vector<Edge> edges;
  std::vector<std::uint8_t> pointUsed; ///< one a point
  std::vector<std::uint8_t> flipped;   ///< one a triangle
};

} // namespace shadow
