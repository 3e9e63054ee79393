#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "SEDGeometry.h"

namespace shadow::benchmarks
{

/// A closed solid of as many flat faces as wanted, with as many sides each on average: a prism whose upright
/// edges are divided until the mean is reached. Triangulated; its faces are its flat regions.
///
/// @pre 3 * faces - 6 <= faces * meanSides / 2, which a prism has, and the right side is whole
TriangleSoup makePrism(std::uint32_t faces, std::uint32_t meanSides);

/// One of the paper's four objects.
struct PaperObject
{
  std::string name;
  TriangleSoup soup;
  std::size_t paperEdges; ///< table 1
};

/// The cube, the sphere (an icosahedron has its 30 edges), the plane (2 x 14 squares, halved, have its 100
/// edges), and the bunny, made coarser until it has about its 2,207 edges, if the file is there.
std::vector<PaperObject> makePaperObjects(const std::string& bunnyFile);

} // namespace shadow::benchmarks
