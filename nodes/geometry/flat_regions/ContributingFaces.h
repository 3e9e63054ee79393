#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "SEDGeometry.h"
#include "TopologyAwareMesh.h"

namespace shadow
{

/// Faces that follow one another.
struct FaceRun
{
  std::uint32_t first;
  std::uint32_t count;
};

/// Faces in runs.
std::size_t countFaces(const std::vector<FaceRun>& runs);

/// The faces of a topology-aware mesh that can have lines: all but those of which EdgeFate knows that no edge
/// is ever a line, within flat parts and without area.
///
/// Lasts on its own; functions that also need positions are handed the geometry it was made from.
///
/// @par Memory  8 bytes a run
/// @par Source  Valient, "Hardware Generated Object Silhouettes", section 4
class ContributingFaces
{
public:
  /// @par Cost  O(faces)
  ContributingFaces(const SEDGeometry& geometry, const TopologyAwareMesh& mesh);

  /// The faces to draw, rising.
  const std::vector<FaceRun>& getRuns() const { return this->runs; }

  /// Of getRuns(), the faces with an edge of some length.
  ///
  /// @param length  model space, at least 0
  /// @par Cost      O(faces)
  std::vector<FaceRun> findLongFrom(const SEDGeometry& geometry, double length) const;

  std::size_t getMemorySize() const { return this->runs.capacity() * sizeof(FaceRun); }

private:
  std::vector<FaceRun> runs;
};

} // namespace shadow
