#include "OutlineLayouts.h"

#include <cstdio>
#include <filesystem>
#include <string>

#include "ContributingFaces.h"
#include "MeshFiles.h"
#include "TestMeshes.h"
#include "TopologyAwareMesh.h"

namespace shadow::benchmarks
{

namespace
{

/// What the paper holds its mesh against: see getOriginalSize().
constexpr double papersFace = 94.0;

/// A face of which no vertex is shared, without indices: the paper's worst case.
constexpr double unsharedFace = 3.0 * 44.0;

void printLayoutsOf(const std::string& name, const SEDGeometry& geometry)
{
  const TopologyAwareMesh mesh(geometry);
  const auto faces = static_cast<double>(mesh.countFaces());
  const std::size_t original = getOriginalSize(geometry.getPositions().size(), mesh.countFaces());
  std::printf("  %-16s %7zu %9zu", name.c_str(), mesh.countFaces(), original);
  for (const TAMLayout layout : {TAMLayout::Full, TAMLayout::Half, TAMLayout::Shared})
  {
    const std::size_t bytes = mesh.pack(geometry, layout).size();
    const auto size = static_cast<double>(bytes);
    std::printf("  %9zu %5.2f %5.2f %5.2f", bytes, size / static_cast<double>(original),
                size / (papersFace * faces), size / (unsharedFace * faces));
  }
  const ContributingFaces contributing(geometry, mesh);
  std::printf("  %8zu\n", mesh.countFaces() - countFaces(contributing.getRuns()));
}

} // namespace

void printLayouts()
{
  std::printf(
      "\nBytes of the topology-aware mesh: measured; over the original's, whose vertices are welded; "
      "over the paper's\n94 a face (paper: 1.53 half, 0.77 shared); over 132 a face, no vertex shared "
      "and no indices (paper: 1.09 half).\n");
  std::printf("  %-16s %7s %9s  %-27s  %-27s  %-27s  left out\n", "", "faces", "original", "full", "half",
              "shared");
  for (const std::string& file : test::findMeshFiles(MODEL_FOLDER))
  {
    printLayoutsOf(std::filesystem::path(file).stem().string(), test::build(test::readMeshFile(file)));
  }
  printLayoutsOf("cube", test::build(test::makeCube()));
  printLayoutsOf("100 plates", test::build(test::makePlates(100)));
}

} // namespace shadow::benchmarks
