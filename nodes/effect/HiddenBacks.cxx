#include "HiddenBacks.h"

#include <algorithm>
#include <utility>

#include "OpenGL.h"
#include "ShadowPrograms.h"
#include "ShadowTarget.h"
#include "View.h"

namespace shadow
{

void HiddenBacks::begin()
{
  this->watched.clear();
  this->hidden.clear();
}

void HiddenBacks::choose(Group& root, const View& view, const glm::dmat4& clipFromWC, std::uint32_t taken)
{
  LargeMeshVisitor visitor(fewestTriangles, view.mirrored);
  root.accept(visitor);
  if (taken == ~0u)
  {
    this->shown = {};
    return;
  }
  Shown now{visitor.getShown(), clipFromWC, view.width, view.height};
  if (!(now == this->shown))
  {
    this->shown = std::move(now);
    this->hiddenIn.clear();
    this->mark(visitor.getMeshes(), taken);
    return;
  }
  for (const LargeMesh& mesh : visitor.getMeshes())
  {
    if (std::find(this->hiddenIn.begin(), this->hiddenIn.end(), mesh.path) != this->hiddenIn.end())
    {
      mesh.state->hiddenSide = mesh.back;
      this->hidden.push_back(mesh);
    }
  }
}

void HiddenBacks::mark(std::vector<LargeMesh> meshes, std::uint32_t taken)
{
  std::stable_sort(meshes.begin(), meshes.end(),
                   [](const LargeMesh& one, const LargeMesh& other)
                   { return one.triangles > other.triangles; });
  std::uint32_t bit = 1u << 31;
  for (const LargeMesh& mesh : meshes)
  {
    while ((taken & bit) != 0)
    {
      bit >>= 1;
    }
    if (bit == 0 || this->watched.size() == most)
    {
      break;
    }
    mesh.state->marked = {bit, mesh.inwards};
    this->watched.push_back({mesh, bit});
    bit >>= 1;
  }
}

void HiddenBacks::ask(vtkOpenGLState* state, ShadowPrograms& programs, ShadowTarget& target)
{
  GLint running = 0;
  glGetQueryiv(GL_SAMPLES_PASSED, GL_CURRENT_QUERY, &running);
  if (running != 0)
  {
    return;
  }
  while (this->queries.size() < this->watched.size())
  {
    glGenQueries(1, &this->queries.emplace_back());
  }
  for (std::size_t i = 0; i < this->watched.size(); ++i)
  {
    glBeginQuery(GL_SAMPLES_PASSED, this->queries[i]);
    this->watched[i].asked = target.drawWhereCleared(state, programs, this->watched[i].bit);
    glEndQuery(GL_SAMPLES_PASSED);
  }
}

void HiddenBacks::fetch()
{
  for (std::size_t i = 0; i < this->watched.size(); ++i)
  {
    GLuint seen = 1;
    if (this->watched[i].asked)
    {
      glGetQueryObjectuiv(this->queries[i], GL_QUERY_RESULT, &seen);
    }
    if (seen == 0)
    {
      this->hidden.push_back(this->watched[i].mesh);
      this->hiddenIn.push_back(this->watched[i].mesh.path);
    }
  }
}

void HiddenBacks::release(bool contextLost)
{
  this->begin();
  this->shown = {};
  if (!contextLost && !this->queries.empty())
  {
    glDeleteQueries(static_cast<GLsizei>(this->queries.size()), this->queries.data());
  }
  this->queries.clear();
}

} // namespace shadow
