#include "VolumeBatch.h"

#include <utility>

#include <vtkOpenGLState.h>
#include <vtkShaderProgram.h>

#include "BufferUpload.h"
#include "ShadowPrograms.h"
#include "VertexLayout.h"

namespace shadow
{

namespace
{

constexpr int lightUnit = SurfaceBatch::firstFreeUnit;

} // namespace

bool VolumeBatch::Place::operator==(const Place& other) const
{
  return this->surface == other.surface && this->part == other.part && this->revision == other.revision &&
         this->mirrored == other.mirrored;
}

void VolumeBatch::update(const SurfaceBatch& batch, int newLight, StencilCount newCount, std::size_t countable)
{
  this->light = newLight;
  this->count = newCount;
  const std::vector<Place> before = std::move(this->places);
  this->findPlaces(batch);
  if (this->places != before || this->layout != batch.getLayout() || this->countableBefore != countable)
  {
    this->layout = batch.getLayout();
    this->countableBefore = countable;
    this->copyClose(batch);
    this->makeChunks(batch, countable);
    this->upload();
  }
  if (!this->isEmpty())
  {
    this->uploadLights(batch);
  }
}

void VolumeBatch::findPlaces(const SurfaceBatch& batch)
{
  this->places.clear();
  this->sides = this->caps = this->silhouetteEdges = 0;
  for (std::size_t surface = 0; surface < batch.getSurfaces().size(); ++surface)
  {
    const BatchedSurface& batched = batch.getSurfaces()[surface];
    const auto entry = batched.path->lights.find(this->light);
    if (entry == batched.path->lights.end() || entry->second.plan.count != this->count || !entry->second.extruded)
    {
      continue;
    }
    const std::vector<ShadowVolume>& volumes = entry->second.volumes;
    for (std::size_t part = 0; part < volumes.size(); ++part)
    {
      if (volumes[part].getTriangleCount() > 0)
      {
        this->places.push_back({surface, part, entry->second.revision, batched.mirrored});
        this->sides += volumes[part].getSideCount();
        this->caps += volumes[part].getCapCount();
        this->silhouetteEdges += volumes[part].silhouetteEdges;
      }
    }
  }
}

const ShadowVolume& VolumeBatch::getVolume(const SurfaceBatch& batch, const Place& place) const
{
  return batch.getSurfaces()[place.surface].path->lights.at(this->light).volumes[place.part];
}

void VolumeBatch::copyClose(const SurfaceBatch& batch)
{
  this->closeCopies.clear();
  this->firstClose.clear();
  for (const Place& place : this->places)
  {
    this->firstClose.push_back(static_cast<std::uint32_t>(this->closeCopies.size()));
    for (const glm::vec4& vertex : this->getVolume(batch, place).close.vertices)
    {
      this->closeCopies.push_back({vertex, static_cast<std::uint32_t>(place.surface)});
    }
  }
}

void VolumeBatch::makeChunks(const SurfaceBatch& batch, std::size_t countable)
{
  this->chunks.clear();
  this->indices.clear();
  Range range{0, 0};
  std::size_t bound = 0;
  for (; range.end < this->places.size(); ++range.end)
  {
    const std::size_t added = this->getVolume(batch, this->places[range.end]).overlapBound;
    if (bound + added > countable && range.end > range.begin)
    {
      this->chunks.push_back({bound, {}});
      this->copyChunk(batch, range);
      range.begin = range.end;
      bound = 0;
    }
    bound += added;
  }
  if (range.end > range.begin)
  {
    this->chunks.push_back({bound, {}});
    this->copyChunk(batch, range);
  }
}

// Fills the last chunk.
void VolumeBatch::copyChunk(const SurfaceBatch& batch, Range range)
{
  for (const bool mirrored : {false, true})
  {
    for (const FacesOf<ShadowVolume>& faces : volumeFaces)
    {
      this->copyFaces(batch, range, {faces.kind, mirrored, false, 0, 0},
                      [&](const ShadowVolume& volume) { return &(volume.*faces.triangles); });
    }
    for (const FacesOf<ShadowVolume::ClosePart>& faces : closeFaces)
    {
      this->copyFaces(batch, range, {faces.kind, mirrored, true, 0, 0},
                      [&](const ShadowVolume& volume) { return &(volume.close.*faces.triangles); });
    }
  }
}

template <class Find>
void VolumeBatch::copyFaces(const SurfaceBatch& batch, Range range, Faces faces, const Find& find)
{
  faces.first = this->indices.size();
  for (std::size_t i = range.begin; i < range.end; ++i)
  {
    const Place& place = this->places[i];
    if (place.mirrored != faces.mirrored)
    {
      continue;
    }
    const std::uint32_t first = faces.close ? this->firstClose[i]
                                            : static_cast<std::uint32_t>(2 * batch.getFirstVertex(place.surface));
    for (const ShadowVolume::Triangle& triangle : *find(this->getVolume(batch, place)))
    {
      this->indices.push_back({triangle[0] + first, triangle[1] + first, triangle[2] + first});
    }
  }
  faces.count = this->indices.size() - faces.first;
  if (faces.count > 0)
  {
    this->chunks.back().faces.push_back(faces);
  }
}

void VolumeBatch::upload()
{
  if (this->vertexArray == 0)
  {
    glGenVertexArrays(1, &this->vertexArray);
    glGenBuffers(1, &this->indexBuffer);
    glGenBuffers(1, &this->closeBuffer);
  }
  glBindVertexArray(this->vertexArray);
  this->bytes = uploadBuffer(GL_ELEMENT_ARRAY_BUFFER, this->indexBuffer, this->indices, GL_STREAM_DRAW);
  this->bytes += uploadBuffer(GL_ARRAY_BUFFER, this->closeBuffer, this->closeCopies, GL_STREAM_DRAW);
  glBindVertexArray(0);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  this->indices = {};
  this->closeCopies = {};
}

void VolumeBatch::uploadLights(const SurfaceBatch& batch)
{
  std::vector<glm::vec4> values;
  values.reserve(3 * batch.getSurfaces().size());
  for (const BatchedSurface& surface : batch.getSurfaces())
  {
    const auto entry = surface.path->lights.find(this->light);
    if (entry == surface.path->lights.end() || !entry->second.extruded)
    {
      values.insert(values.end(), 3, glm::vec4(0.0f)); // none of its volumes is drawn
      continue;
    }
    const LightValues lightValues = makeLightValues(entry->second.lightMC, surface.geometry->getReach());
    values.push_back(lightValues.lightMC);
    values.emplace_back(lightValues.lightLowMC, lightValues.rayLength);
    values.emplace_back(farPlaneToModel(entry->second.plan.farPlaneWC, surface.wcFromMC));
  }
  this->lights.upload(values);
}

void VolumeBatch::draw(SurfaceBatch& batch, const FaceCounter::Target& target, bool mirrored,
                       const std::function<void(std::size_t)>& makeRoom)
{
  const auto program = static_cast<unsigned int>(target.program->GetHandle());
  batch.bindObjects(target.state, target.program);
  this->lights.bind(target.state, program, lightUnit, "lightTexels");
  for (const Chunk& chunk : this->chunks)
  {
    makeRoom(chunk.bound);
    glBindVertexArray(this->vertexArray);
    for (const Faces& faces : chunk.faces)
    {
      SurfaceBatch::bindCopies(target.program, faces.close ? this->closeBuffer : batch.getCopies());
      const FaceCounter counter(target, this->count, faces.mirrored != mirrored);
      setDepthBias(target.program, target.reversedDepth, faces.kind.side);
      counter.count(faces.kind.multiplicity, faces.kind.inward,
                    [&] { drawTriangles(faces.first, faces.count); });
    }
    glBindVertexArray(0);
  }
  BufferTexels::unbind(target.state, lightUnit);
  SurfaceBatch::unbindObjects(target.state);
}

void VolumeBatch::release(bool contextLost)
{
  this->lights.release(contextLost);
  if (!contextLost)
  {
    glDeleteVertexArrays(1, &this->vertexArray);
    glDeleteBuffers(1, &this->indexBuffer);
    glDeleteBuffers(1, &this->closeBuffer);
  }
  this->vertexArray = this->indexBuffer = this->closeBuffer = 0;
  this->layout = 0;
  this->bytes = 0;
  this->places.clear();
  this->chunks.clear();
}

} // namespace shadow
