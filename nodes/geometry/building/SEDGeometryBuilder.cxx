#include "SEDGeometryBuilder.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "CopiedTriangles.h"
#include "EdgeConnector.h"
#include "GridOrigin.h"
#include "ManifoldSplitter.h"
#include "OutwardOrientation.h"
#include "SidePairing.h"
#include "TriangleOrder.h"
#include "VertexWelder.h"

namespace shadow
{

namespace
{

/// OpenMesh numbers half-edges with an int; there are up to six a triangle.
constexpr std::size_t mostTriangles = 0x7fffffff / 6;

bool isFinite(const glm::dvec3& point)
{
  return std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z);
}

/// The same winding, with the smallest corner first: what follows depends on the winding alone.
std::array<std::uint32_t, 3> startAtSmallest(std::array<std::uint32_t, 3> corners)
{
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  return corners;
}

template <typename T>
void release(std::vector<T>& values)
{
  std::vector<T>().swap(values);
}

} // namespace

std::optional<SEDGeometry> SEDGeometryBuilder::build(TriangleSoup soup, std::string& error)
{
  this->geometry.report.inputTriangles = soup.triangles.size();
  if (!this->findUsedPoints(soup, error) || !this->chooseOrigin(soup, error) ||
      !this->weldCorners(soup, error))
  {
    return std::nullopt;
  }
  std::vector<std::uint8_t> copies;
  if (this->options.copiesCountOnce)
  {
    copies = findCopies(this->geometry.triangles, this->geometry.positions.size());
  }
  this->orderTriangles();
  this->setCopiesApart(copies);
  this->flipped.assign(this->geometry.triangles.size(), 0);
  this->connect();
  orientOutwards(this->geometry.triangles, this->edges, this->geometry.positions, this->flipped);
  this->geometry.report.flippedTriangles =
      static_cast<std::size_t>(std::count(this->flipped.begin(), this->flipped.end(), std::uint8_t{1}));
  this->countEdgesAndBounds();
  this->computePlanes();
  this->makeClusters();
  this->findCommonPlane();
  this->identify();
  return std::move(this->geometry);
}

bool SEDGeometryBuilder::findUsedPoints(const TriangleSoup& soup, std::string& error)
{
  if (soup.triangles.empty())
  {
    error = "the mesh has no triangles";
    return false;
  }
  if (soup.triangles.size() > mostTriangles)
  {
    error = "the mesh has " + std::to_string(soup.triangles.size()) + " triangles; at most " +
            std::to_string(mostTriangles) + " can be connected";
    return false;
  }
  this->pointUsed.assign(soup.points.size(), 0);
  for (std::size_t triangle = 0; triangle < soup.triangles.size(); ++triangle)
  {
    for (const std::uint32_t point : soup.triangles[triangle])
    {
      if (point >= soup.points.size())
      {
        error = "triangle " + std::to_string(triangle) + " uses point " + std::to_string(point) + " of " +
                std::to_string(soup.points.size());
        return false;
      }
      this->pointUsed[point] = 1;
    }
  }
  return true;
}

/// The origin is near the centre of the points in use: a stray point that no triangle uses must not cost
/// precision.
bool SEDGeometryBuilder::chooseOrigin(const TriangleSoup& soup, std::string& error)
{
  glm::dvec3 lower(std::numeric_limits<double>::max());
  glm::dvec3 upper(std::numeric_limits<double>::lowest());
  for (std::size_t point = 0; point < soup.points.size(); ++point)
  {
    if (!isFinite(soup.points[point]))
    {
      error = "point " + std::to_string(point) + " is not finite";
      return false;
    }
    if (this->pointUsed[point])
    {
      lower = glm::min(lower, soup.points[point]);
      upper = glm::max(upper, soup.points[point]);
    }
  }
  this->geometry.origin = chooseGridOrigin(lower, upper);
  const glm::dvec3 reach = glm::max(upper - this->geometry.origin, this->geometry.origin - lower);
  // Not by a conversion to float and back: GCC 12 takes two of these, vectorised, for nothing.
  constexpr double farthest = std::numeric_limits<float>::max();
  if (!(std::max({reach.x, reach.y, reach.z}) <= farthest))
  {
    error = "the mesh is larger than single precision can hold";
    return false;
  }
  return true;
}

bool SEDGeometryBuilder::weldCorners(TriangleSoup& soup, std::string& error)
{
  // A closed mesh has half as many vertices as triangles; reserve for that, whatever copies the soup holds.
  const std::size_t sizeHint = std::min(soup.points.size(), soup.triangles.size() / 2 + 1024);
  WeldedPoints welded =
      weldPoints(soup.points, this->pointUsed, this->geometry.origin, this->options.weldTolerance, sizeHint);
  release(soup.points);
  release(this->pointUsed);
  this->geometry.positions = std::move(welded.positions);
  this->geometry.triangles = std::move(soup.triangles);

  std::vector<std::array<std::uint32_t, 3>>& triangles = this->geometry.triangles;
  std::size_t kept = 0;
  for (const std::array<std::uint32_t, 3>& points : triangles)
  {
    const std::array<std::uint32_t, 3> corners = {welded.vertexOf[points[0]], welded.vertexOf[points[1]],
                                                  welded.vertexOf[points[2]]};
    if (corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0])
    {
      triangles[kept++] = startAtSmallest(corners);
    }
  }
  this->geometry.report.degenerateTriangles = triangles.size() - kept;
  triangles.resize(kept);
  if (triangles.empty())
  {
    error = "every triangle of the mesh is degenerate";
    return false;
  }
  return true;
}

void SEDGeometryBuilder::orderTriangles()
{
  std::vector<std::array<std::uint32_t, 3>>& triangles = this->geometry.triangles;
  this->hasPreviousOrder = this->options.previous != nullptr && this->hasTrianglesOf(*this->options.previous);
  if (this->hasPreviousOrder)
  {
    this->geometry.inputOrder = this->options.previous->inputOrder;
    putInOrder(triangles, this->geometry.inputOrder);
    return;
  }
  this->geometry.inputOrder = sortIntoPatches(triangles, this->geometry.positions, this->options.parallelFor);
}

void SEDGeometryBuilder::setCopiesApart(const std::vector<std::uint8_t>& copies)
{
  const std::size_t vertices = this->geometry.positions.size();
  this->geometry.copies = shadow::setCopiesApart(copies, this->geometry.inputOrder, this->geometry.triangles,
                                                 this->geometry.positions);
  this->geometry.report.splitVertices = this->geometry.positions.size() - vertices;
}

/// Do the triangles, in the other mesh's order, have its corners, but for vertices that it has split?
bool SEDGeometryBuilder::hasTrianglesOf(const SEDGeometry& other) const
{
  const std::size_t welded = this->geometry.positions.size();
  if (other.triangles.size() != this->geometry.triangles.size() ||
      other.positions.size() - other.report.splitVertices != welded)
  {
    return false;
  }
  for (std::size_t place = 0; place < other.triangles.size(); ++place)
  {
    const std::array<std::uint32_t, 3>& corners = this->geometry.triangles[other.inputOrder[place]];
    const std::array<std::uint32_t, 3>& wanted = other.triangles[place];
    if (!std::all_of(wanted.begin(), wanted.end(),
                     [&](std::uint32_t vertex) {
                       return vertex >= welded ||
                              std::find(corners.begin(), corners.end(), vertex) != corners.end();
                     }))
    {
      return false;
    }
  }
  return true;
}

/// Do the triangles, which are in the other mesh's order, run as its input's did, which could be connected as
/// they were? @post then pairSides() would find the same edges
bool SEDGeometryBuilder::isConnectedAs(const SEDGeometry& other) const
{
  bool same = other.manifold;
  for (std::size_t place = 0; same && place < other.triangles.size(); ++place)
  {
    std::array<std::uint32_t, 3> corners = other.triangles[place];
    if (other.inputReversed.test(place))
    {
      std::swap(corners[1], corners[2]);
    }
    same = this->geometry.triangles[place] == startAtSmallest(corners);
  }
  return same;
}

void SEDGeometryBuilder::connect()
{
  this->hasPreviousEdges = this->hasPreviousOrder && this->isConnectedAs(*this->options.previous);
  if (this->hasPreviousEdges)
  {
    this->edges = this->options.previous->getEdges().toVector();
    this->geometry.manifold = true;
    return;
  }
  // Most meshes are manifold already. The others start again, cut and turned.
  this->geometry.manifold = this->connectManifold();
  if (!this->geometry.manifold)
  {
    this->split();
    if (!this->connectManifold())
    {
      this->connectOneByOne();
    }
  }
}

bool SEDGeometryBuilder::connectManifold()
{
  return pairSides(this->geometry.triangles, this->geometry.positions.size(), this->options.parallelFor,
                   this->edges);
}

void SEDGeometryBuilder::split()
{
  std::vector<glm::vec3>& positions = this->geometry.positions;
  SEDGeometryReport& report = this->geometry.report;
  ManifoldSplitter splitter(this->geometry.triangles, positions);
  splitter.run();
  report.nonManifoldEdges = splitter.getNonManifoldEdges();
  report.splitVertices += splitter.getSplitVertices();
  this->flipped = splitter.getFlipped();
}

/// What even cut is no manifold, as fans that are apart may have an edge between the same two vertices each.
void SEDGeometryBuilder::connectOneByOne()
{
  std::vector<glm::vec3>& positions = this->geometry.positions;
  EdgeConnector connector(positions.size(), this->geometry.triangles.size());
  for (std::array<std::uint32_t, 3>& triangle : this->geometry.triangles)
  {
    if (connector.add(triangle))
    {
      continue;
    }
    // A second edge between the same two vertices: this triangle has to stand alone.
    for (std::uint32_t& corner : triangle)
    {
      positions.push_back(glm::vec3(positions[corner]));
      corner = connector.addVertex();
      ++this->geometry.report.splitVertices;
    }
    connector.add(triangle);
  }
  this->edges = connector.readEdges();
}

std::optional<SEDGeometry> buildSEDGeometry(TriangleSoup soup, const SEDGeometryOptions& options,
                                            std::string& error)
{
  return SEDGeometryBuilder(options).build(std::move(soup), error);
}

} // namespace shadow
