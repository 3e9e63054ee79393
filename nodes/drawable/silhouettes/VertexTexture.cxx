#include "VertexTexture.h"

#include <algorithm>

#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkShaderProgram.h>

#include "GLStateScope.h"
#include "OpenGL.h"

namespace shadow
{

namespace
{

constexpr const char* noShader = "a shader of the vertex texture method does not compile on this GL";

} // namespace

struct VertexTexture::PreparedEdges : Prepared
{
  explicit PreparedEdges(int maximumSide) : Prepared(TexelFormat::UInt4, maximumSide) {}
  void release(bool contextLost) override
  {
    this->points.release(contextLost);
    this->Prepared::release(contextLost);
  }
  std::size_t getMemorySize() const override
  {
    return this->points.getMemorySize() + this->Prepared::getMemorySize();
  }

  EdgePoints points;
};

std::unique_ptr<PreparedSilhouette::Prepared> VertexTexture::makePrepared() const
{
  return std::make_unique<PreparedEdges>(this->side);
}

std::string VertexTexture::getFacingSwitches() const
{
  return this->normals == Normals::OncePerTriangle ? this->PreparedSilhouette::getFacingSwitches() : "";
}

void VertexTexture::bindFacing(vtkShaderProgram* program, const Surface& surface,
                               const std::vector<Light>& lights)
{
  if (this->normals == Normals::OncePerTriangle)
  {
    this->PreparedSilhouette::bindFacing(program, surface, lights);
  }
  else
  {
    this->GPUSilhouette::bindFacing(program, surface, lights);
  }
}

bool VertexTexture::find(const std::vector<Change>& surfaces, std::string& error)
{
  // The clip volume does not matter here, and is not changed.
  const GLStateScope scope(this->getFrame().window->GetState(), false);
  const bool faced = this->normals != Normals::OncePerTriangle ||
                     std::all_of(surfaces.begin(), surfaces.end(),
                                 [&](const Change& change) { return this->findFacing(change, error); });
  return faced && std::all_of(surfaces.begin(), surfaces.end(),
                              [&](const Change& change) { return this->findEdges(change, error); });
}

bool VertexTexture::findFacing(const Change& change, std::string& error)
{
  const Surface& surface = change.surface;
  TexelArray& facing = change.prepared->facing;
  if (!facing.allocate(surface.geode->getGeometry().getTriangles().size(), error))
  {
    return false;
  }
  vtkShaderProgram* program = this->useTables(ShadowPrograms::TriangleFacing, surface);
  if (program == nullptr)
  {
    error = noShader;
    return false;
  }
  this->bindCorners(static_cast<unsigned int>(program->GetHandle()), surface, *this->getFrame().lights);
  return this->painter.paint(this->getFrame().window->GetState(), facing, program, error);
}

bool VertexTexture::findEdges(const Change& change, std::string& error)
{
  const Surface& surface = change.surface;
  const SEDGeometry& geometry = surface.geode->getGeometry();
  auto& prepared = static_cast<PreparedEdges&>(*change.prepared);
  if (!prepared.edges.allocate(geometry.getEdges().size(), error))
  {
    return false;
  }
  vtkOpenGLState* state = this->getFrame().window->GetState();
  const bool asPublished = this->normals == Normals::PerEdgeAsPublished;
  vtkShaderProgram* program =
      this->useTables(ShadowPrograms::EdgeStates, surface,
                      this->getFacingSwitches() + (asPublished ? "#define SHADOW_NORMAL_PER_EDGE\n" : ""));
  if (program == nullptr)
  {
    error = noShader;
    return false;
  }
  this->bindFacing(program, surface, *this->getFrame().lights);
  glUniform1ui(glGetUniformLocation(static_cast<GLuint>(program->GetHandle()), "closedLights"),
               lightBits(change, Which::LightFacingOnly));
  if (!asPublished)
  {
    return this->painter.paint(state, prepared.edges, program, error);
  }
  if (prepared.geometry.lock() != surface.geode->getSharedGeometry())
  {
    prepared.points.upload(geometry);
  }
  return this->painter.paint(
      state, prepared.edges, program,
      [&](std::size_t first, std::size_t count) { prepared.points.draw(program, first, count); }, error);
}

void VertexTexture::bindSilhouette(vtkShaderProgram* program, const Surface& surface, const Light& /*light*/)
{
  this->getEdgeTexels(*surface.path)
      .bind(this->getFrame().window->GetState(), static_cast<unsigned int>(program->GetHandle()), edgeUnit,
            "edgeStateTexels", "edgeStateLayer");
}

void VertexTexture::release(bool contextLost)
{
  this->painter.release(contextLost);
  this->PreparedSilhouette::release(contextLost);
}

} // namespace shadow
