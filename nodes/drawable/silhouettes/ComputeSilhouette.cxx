#include "ComputeSilhouette.h"

#include <algorithm>
#include <array>
#include <vector>

#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkShaderProgram.h>

#include "OpenGL.h"
#include "Shaders.h"

namespace shadow
{

namespace
{

/// Of one list: quads, fans.
using Commands = std::array<EdgeQuads::Command, 2>;

/// Writes of the shaders before are there for what comes, and reads of what came before are over.
void waitForWrites()
{
  glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT |
                  GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT |
                  GL_FRAMEBUFFER_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT);
}

} // namespace

struct ComputeSilhouette::PreparedLists : Prepared
{
  explicit PreparedLists(int maximumSide) : Prepared(TexelFormat::UInt1, maximumSide) {}
  void release(bool contextLost) override
  {
    if (!contextLost && this->commands != 0)
    {
      glDeleteBuffers(1, &this->commands);
    }
    this->commands = 0;
    this->Prepared::release(contextLost);
  }
  std::size_t getMemorySize() const override
  {
    return this->lights.size() * sizeof(Commands) + this->Prepared::getMemorySize();
  }

  /// No edges on any list. @post the buffer is bound to shader storage 0
  void clearCommands()
  {
    if (this->commands == 0)
    {
      glGenBuffers(1, &this->commands);
    }
    const std::vector<Commands> none(std::max<std::size_t>(this->lights.size(), 1));
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, this->commands);
    glBufferData(GL_SHADER_STORAGE_BUFFER, static_cast<GLsizeiptr>(none.size() * sizeof(Commands)),
                 none.data(), GL_DYNAMIC_COPY);
  }

  unsigned int commands = 0;
};

ComputeSilhouette::ComputeSilhouette(int mostGroups, int maximumSide)
    : side(maximumSide), facingProgram(shaders::facing_comp, "facing.comp", mostGroups),
      listProgram(shaders::silhouette_comp, "silhouette.comp", mostGroups)
{
}

std::unique_ptr<PreparedSilhouette::Prepared> ComputeSilhouette::makePrepared() const
{
  return std::make_unique<PreparedLists>(this->side);
}

bool ComputeSilhouette::find(const std::vector<Change>& surfaces, std::string& error)
{
  waitForWrites();
  bool found = std::all_of(surfaces.begin(), surfaces.end(),
                           [&](const Change& change) { return this->findFacing(change, error); });
  waitForWrites();
  found = found && std::all_of(surfaces.begin(), surfaces.end(),
                               [&](const Change& change) { return this->findLists(change, error); });
  waitForWrites();
  glBindImageTexture(0, 0, 0, GL_FALSE, 0, GL_READ_ONLY, GL_R32UI);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, 0);
  ComputeProgram::useNone();
  return found;
}

bool ComputeSilhouette::findFacing(const Change& change, std::string& error)
{
  const Surface& surface = change.surface;
  const std::size_t triangles = surface.geode->getGeometry().getTriangles().size();
  TexelArray& facing = change.prepared->facing;
  if (!facing.allocate(triangles, error) || !this->facingProgram.use(this->getFrame().window, error))
  {
    return false;
  }
  const unsigned int program = this->facingProgram.getHandle();
  this->getTables(surface).bind(this->getFrame().window->GetState(), program, tableUnit);
  this->bindCorners(program, surface, *this->getFrame().lights);
  facing.bindImage(0);
  this->facingProgram.setPair("imageLayer", facing.getWidth(), facing.getHeight());
  this->facingProgram.setInteger("triangleCount", static_cast<int>(triangles));
  this->facingProgram.dispatch(triangles);
  return true;
}

bool ComputeSilhouette::findLists(const Change& change, std::string& error)
{
  const Surface& surface = change.surface;
  const std::size_t edges = surface.geode->getGeometry().getEdges().size();
  auto& prepared = static_cast<PreparedLists&>(*change.prepared);
  const std::size_t lists = std::max<std::size_t>(prepared.lights.size(), 1);
  if (!prepared.edges.allocate(edges * lists, error) ||
      !this->listProgram.use(this->getFrame().window, error))
  {
    return false;
  }
  const unsigned int program = this->listProgram.getHandle();
  this->getTables(surface).bind(this->getFrame().window->GetState(), program, tableUnit);
  this->bindFacingTexture(program, *surface.path);
  prepared.edges.bindImage(0);
  prepared.clearCommands();
  this->listProgram.setPair("imageLayer", prepared.edges.getWidth(), prepared.edges.getHeight());
  this->listProgram.setInteger("edgeCount", static_cast<int>(edges));
  this->listProgram.setUnsigned("lights", lightBits(change, Which::All));
  this->listProgram.setUnsigned("closedLights", lightBits(change, Which::LightFacingOnly));
  this->listProgram.dispatch(edges);
  return true;
}

std::size_t ComputeSilhouette::getList(const Surface& surface, const Light& light) const
{
  const auto& lights = this->getPrepared(*surface.path).lights;
  return static_cast<std::size_t>(std::count_if(
      lights.begin(), lights.end(), [&](const auto& other) { return other.first < light.index; }));
}

ComputeSilhouette::Lists ComputeSilhouette::getLists(const NodePath& path) const
{
  const auto& prepared = static_cast<const PreparedLists&>(this->getPrepared(path));
  return {&prepared.edges, prepared.commands};
}

void ComputeSilhouette::bindSilhouette(vtkShaderProgram* program, const Surface& surface, const Light& light)
{
  this->getLists(*surface.path)
      .entries->bind(this->getFrame().window->GetState(), static_cast<unsigned int>(program->GetHandle()),
                     edgeUnit, "listTexels", "listLayer");
  const std::size_t edges = surface.geode->getGeometry().getEdges().size();
  program->SetUniformi("listBegin", static_cast<int>(this->getList(surface, light) * edges));
}

void ComputeSilhouette::drawQuads(EdgeQuads& edgeQuads, const Surface& surface, const Light& light, bool fan)
{
  edgeQuads.drawIndirect(this->getLists(*surface.path).commands,
                         this->getList(surface, light) * sizeof(Commands),
                         surface.geode->getGeometry().getEdges().size(), fan);
}

void ComputeSilhouette::release(bool contextLost)
{
  this->facingProgram.release(contextLost);
  this->listProgram.release(contextLost);
  this->PreparedSilhouette::release(contextLost);
}

} // namespace shadow
