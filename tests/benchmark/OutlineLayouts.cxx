#include "OutlineLayouts.h"

#include <array>
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

void printLayoutsOf(const std::string& name, const SEDGeometry& geometry)
{
  const TopologyAwareMesh mesh(geometry);
  const std::size_t original = getOriginalSize(geometry.getPositions().size(), mesh.countFaces());
  std::printf("  %-16s %8zu %12zu", name.c_str(), mesh.countFaces(), original);
  for (const TAMLayout layout : {TAMLayout::Full, TAMLayout::Half, TAMLayout::Shared})
  {
    const std::size_t bytes = mesh.pack(geometry, layout).size();
    std::printf(" %11zu %5.2f %5.2f", bytes, static_cast<double>(bytes) / static_cast<double>(original),
                static_cast<double>(bytes) / (94.0 * static_cast<double>(mesh.countFaces())));
  }
  const ContributingFaces contributing(geometry, mesh);
  std::printf(" %12zu\n", mesh.countFaces() - countFaces(contributing.getRuns()));
}

} // namespace

void printLayouts()
{
  std::printf("\nbytes of the topology-aware mesh; against the original, of welded vertices, and against the "
              "paper's 94 bytes a face (there: 1.53 half, 0.77 shared; 1.09 half against unshared vertices "
              "without indices)\n");
  std::printf("  %-16s %8s %12s %23s %23s %23s    left out\n", "", "faces", "original", "full", "half",
              "shared");
  for (const std::string& file : test::findMeshFiles(MODEL_FOLDER))
  {
    printLayoutsOf(std::filesystem::path(file).stem().string(), test::build(test::readMeshFile(file)));
  }
  printLayoutsOf("cube", test::build(test::makeCube()));
  printLayoutsOf("100 plates", test::build(test::makePlates(100)));
}

} // namespace shadow::benchmarks
