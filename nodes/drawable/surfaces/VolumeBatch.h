#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "FaceCounter.h"
#include "FloatTexels.h"
#include "SEDGeode.h"
#include "ShadowVolume.h"
#include "SurfaceBatch.h"
#include "VolumeFaces.h"

namespace shadow
{

/// The volumes of a batch for one light that are counted in one way: the indices of all faces in one buffer, and
/// what the shader looks up for each surface. Has their faces counted.
class VolumeBatch
{
public:
  VolumeBatch() = default;
  VolumeBatch(const VolumeBatch&) = delete;
  VolumeBatch& operator=(const VolumeBatch&) = delete;

  /// Goes over to the volumes as they are. What is on the GPU stays where all are as before.
  /// @param light      Light::index
  /// @param countable  faces on a pixel that can be counted, see mostCountableIn()
  void update(const SurfaceBatch& batch, int light, StencilCount count, std::size_t countable);

  bool isEmpty() const { return this->places.empty(); }

  /// Counts the faces.
  /// @param mirrored  View::mirrored
  /// @param makeRoom  called before faces with a bound on how many a pixel shows
  /// @pre update() called for them; the program is of ShadowPrograms::Volume... with SurfaceBatch::batchSwitch
  void draw(SurfaceBatch& batch, const FaceCounter::Target& target, bool mirrored,
            const std::function<void(std::size_t)>& makeRoom);

  /// Of the volumes: triangles as often as they count, silhouette edges.
  std::size_t getSides() const { return this->sides; }
  std::size_t getCaps() const { return this->caps; }
  std::size_t getSilhouetteEdges() const { return this->silhouetteEdges; }

  std::size_t getMemorySize() const { return this->bytes + this->lights.getMemorySize(); }

  /// Frees the GL objects. @pre their context is current, or is gone and @p contextLost
  void release(bool contextLost);

private:
  /// A volume as it was copied.
  struct Place
  {
    std::size_t surface = 0;
    std::size_t part = 0;       ///< of PathLightState::volumes
    std::uint64_t revision = 0; ///< PathLightState::revision
    bool mirrored = false;

    bool operator==(const Place& other) const;
  };
  /// Faces that one call draws.
  struct Faces
  {
    FaceKind kind;
    bool mirrored;
    bool close; ///< of ShadowVolume::close
    std::size_t first;
    std::size_t count;
  };
  /// Volumes that can be counted without looking in between.
  struct Chunk
  {
    std::size_t bound = 0;
    std::vector<Faces> faces;
  };
  struct Range
  {
    std::size_t begin;
    std::size_t end;
  };

  void findPlaces(const SurfaceBatch& batch);
  const ShadowVolume& getVolume(const SurfaceBatch& batch, const Place& place) const;
  void makeChunks(const SurfaceBatch& batch, std::size_t countable);
  void copyChunk(const SurfaceBatch& batch, Range range);
  template <class Find>
  void copyFaces(const SurfaceBatch& batch, Range range, Faces faces, const Find& find);
  void copyClose(const SurfaceBatch& batch);
  void upload();
  void uploadLights(const SurfaceBatch& batch);

  int light = 0;
  StencilCount count = StencilCount::ZPass;
  std::uint64_t layout = 0; ///< SurfaceBatch::getLayout() of what was copied
  std::size_t countableBefore = 0;
  std::vector<Place> places;
  std::vector<std::uint32_t> firstClose; ///< a place: its first vertex in closeCopies
  std::vector<Chunk> chunks;
  std::vector<ShadowVolume::Triangle> indices;  ///< while they are gathered
  std::vector<SurfaceBatch::Copy> closeCopies;  ///< the same
  std::size_t sides = 0;
  std::size_t caps = 0;
  std::size_t silhouetteEdges = 0;
  std::size_t bytes = 0;
  unsigned int vertexArray = 0;
  unsigned int indexBuffer = 0;
  unsigned int closeBuffer = 0;
  FloatTexels lights;
};

} // namespace shadow
