// The faces of a topology-aware mesh.
#include "SEDGeometryDrawable.h"

#include <vtkShaderProgram.h>

#include "BufferUpload.h"
#include "ContributingFaces.h"
#include "TopologyAwareMesh.h"

namespace shadow
{

namespace
{

constexpr int positionUnit = 2;
constexpr int cornerUnit = 3;

/// Three vertices a face, or nine: see shaders/outlines/outlineFace.vert.
void drawRuns(vtkShaderProgram* program, const std::vector<FaceRun>& runs, bool split)
{
  if (runs.empty())
  {
    return;
  }
  const std::uint32_t verticesOfFace = split ? 9 : 3;
  std::vector<GLint> firsts;
  std::vector<GLsizei> counts;
  for (const FaceRun& run : runs)
  {
    firsts.push_back(static_cast<GLint>(verticesOfFace * run.first));
    counts.push_back(static_cast<GLsizei>(verticesOfFace * run.count));
  }
  program->SetUniformi("splits", split ? 1 : 0);
  glMultiDrawArrays(GL_TRIANGLES, firsts.data(), counts.data(), static_cast<GLsizei>(runs.size()));
}

} // namespace

bool SEDGeometryDrawable::bindFaceTexels(vtkOpenGLState* state, vtkShaderProgram* program)
{
  if (!this->positionTexels.attach(this->vertexBuffer, 3 * this->vertices) ||
      !this->cornerTexels.attach(this->indexBuffer, 3 * this->triangles))
  {
    return false;
  }
  const auto handle = static_cast<unsigned int>(program->GetHandle());
  this->positionTexels.bind(state, handle, positionUnit, "positionTexels");
  this->cornerTexels.bind(state, handle, cornerUnit, "cornerTexels");
  return true;
}

void SEDGeometryDrawable::unbindFaceTexels(vtkOpenGLState* state)
{
  BufferTexels::unbind(state, positionUnit);
  BufferTexels::unbind(state, cornerUnit);
}

bool SEDGeometryDrawable::drawFaces(vtkOpenGLState* state, vtkShaderProgram* program,
                                    const TopologyAwareMesh& mesh, const std::vector<FaceRun>& runs,
                                    const std::vector<FaceRun>& split)
{
  const std::size_t normals = 3 * this->triangles;
  if (normals > BufferTexels::findMost() || !this->bindFaceTexels(state, program))
  {
    return false;
  }
  if (this->normalBuffer == 0)
  {
    glGenBuffers(1, &this->normalBuffer);
  }
  if (!this->normalsUploaded)
  {
    this->normalBytes = uploadBuffer(GL_TEXTURE_BUFFER, this->normalBuffer,
                                     mesh.pack(*this->geometry, TAMLayout::Shared), GL_STATIC_DRAW);
    this->normalsUploaded = true;
    glBindBuffer(GL_TEXTURE_BUFFER, 0);
  }
  this->normalTexels.attach(this->normalBuffer, normals);
  this->normalTexels.bind(state, static_cast<unsigned int>(program->GetHandle()), firstFreeUnit,
                          "normalTexels");
  drawRuns(program, runs, false);
  drawRuns(program, split, true);
  BufferTexels::unbind(state, firstFreeUnit);
  unbindFaceTexels(state);
  return true;
}

} // namespace shadow
