#include "PassContext.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <glm/gtc/matrix_access.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <vtkMatrix3x3.h>
#include <vtkMatrix4x4.h>
#include <vtkOpenGLCamera.h>
#include <vtkOpenGLState.h>
#include <vtkProp.h>
#include <vtkRenderState.h>

#include "OpenGL.h"

namespace shadow
{

void PassContext::acquire(const std::function<void()>& forget)
{
  this->window->MakeCurrent();
  if (this->sentinel->GetHandle() == 0)
  {
    forget();
    GLint before = 0;
    glGetIntegerv(GL_TEXTURE_BINDING_2D, &before);
    this->sentinel->SetContext(this->window);
    this->sentinel->Allocate2D(1, 1, 4, VTK_UNSIGNED_CHAR);
    glBindTexture(GL_TEXTURE_2D, static_cast<GLuint>(before));
  }
}

void PassContext::release(const std::function<void(bool contextLost)>& free)
{
  if (this->isLost())
  {
    free(true);
    return;
  }
  const ContextScope scope(this->window);
  free(false);
  this->sentinel->ReleaseGraphicsResources(this->window);
}

View currentView(vtkOpenGLRenderer* renderer, vtkOpenGLRenderWindow* window)
{
  auto* camera = static_cast<vtkOpenGLCamera*>(renderer->GetActiveCamera());
  vtkMatrix4x4* viewFromWorld = nullptr;
  vtkMatrix3x3* normals = nullptr;
  vtkMatrix4x4* clipFromView = nullptr;
  vtkMatrix4x4* clipFromWorld = nullptr;
  camera->GetKeyMatrices(renderer, viewFromWorld, normals, clipFromView, clipFromWorld);
  // These matrices are transposed, and VTK stores rows where GLM stores columns.
  const glm::dmat4 clip = glm::make_mat4(clipFromView->GetData()) * glm::make_mat4(viewFromWorld->GetData());
  int viewport[4] = {0, 0, 0, 0};
  window->GetState()->vtkglGetIntegerv(GL_VIEWPORT, viewport);
  return makeView(clip, viewport[2], viewport[3]);
}

std::string findFault(const View& view)
{
  const double* elements = glm::value_ptr(view.clipFromWC);
  const bool finite = std::all_of(elements, elements + 16, [](double element)
                                  { return std::isfinite(static_cast<float>(element)); });
  // Where the squares of its coordinates overflow, a camera has no directions, and VTK makes them 0; a scale
  // too large does the same.
  const auto hasDirection = [&](int row)
  { return glm::vec3(glm::row(view.clipFromWC, row)) != glm::vec3(0.0f); };
  const bool drawable = finite && hasDirection(0) && hasDirection(1);
  return drawable ? "" : "the camera's position or scale is beyond what single precision holds";
}

std::set<vtkProp*> drawnProps(const vtkRenderState* s)
{
  vtkProp** props = s->GetPropArray();
  return {props, props + s->GetPropArrayCount()};
}

void PropExclusions::set(vtkProp* prop, bool excluded)
{
  for (auto entry = this->props.begin(); entry != this->props.end();)
  {
    entry = entry->second == nullptr ? this->props.erase(entry) : std::next(entry);
  }
  if (excluded)
  {
    this->props[prop] = prop;
  }
  else
  {
    this->props.erase(prop);
  }
}

bool PropExclusions::has(vtkProp* prop) const
{
  const auto entry = this->props.find(prop);
  return entry != this->props.end() && entry->second == prop;
}

} // namespace shadow
