#include "GLStateScope.h"

#include <cstddef>
#include <iterator>

#include "OpenGL.h"

namespace shadow
{

namespace
{

int getInteger(GLenum name)
{
  GLint value = 0;
  glGetIntegerv(name, &value);
  return value;
}

struct TextureKind
{
  GLenum target;
  GLenum binding;
};
constexpr TextureKind textureKinds[] = {
    {GL_TEXTURE_2D, GL_TEXTURE_BINDING_2D},
    {GL_TEXTURE_2D_ARRAY, GL_TEXTURE_BINDING_2D_ARRAY},
    {GL_TEXTURE_2D_MULTISAMPLE, GL_TEXTURE_BINDING_2D_MULTISAMPLE},
    {GL_TEXTURE_BUFFER, GL_TEXTURE_BINDING_BUFFER},
};

void setEnabled(GLenum name, bool enabled)
{
  if (enabled)
  {
    glEnable(name);
  }
  else
  {
    glDisable(name);
  }
}

} // namespace

GLStateScope::GLStateScope(vtkOpenGLState* vtkState, bool hasClipControl)
    : state(vtkState), viewport(vtkState), scissor(vtkState), colorMask(vtkState), depthMask(vtkState),
      depthFunc(vtkState), activeTexture(vtkState), scissorTest(vtkState, GL_SCISSOR_TEST),
      depthTest(vtkState, GL_DEPTH_TEST), stencilTest(vtkState, GL_STENCIL_TEST), blend(vtkState, GL_BLEND),
      cullFace(vtkState, GL_CULL_FACE), blendFunction(vtkState), front(readStencil(true)),
      back(readStencil(false)), cullFaceMode(getInteger(GL_CULL_FACE_MODE)),
      frontFace(getInteger(GL_FRONT_FACE)), provokingVertex(getInteger(GL_PROVOKING_VERTEX)),
      logicOpMode(getInteger(GL_LOGIC_OP_MODE)), stencilClear(getInteger(GL_STENCIL_CLEAR_VALUE)),
      logicOp(glIsEnabled(GL_COLOR_LOGIC_OP) == GL_TRUE), depthClamp(glIsEnabled(GL_DEPTH_CLAMP) == GL_TRUE),
      clipDistance(glIsEnabled(GL_CLIP_DISTANCE0) == GL_TRUE),
      polygonOffset(glIsEnabled(GL_POLYGON_OFFSET_FILL) == GL_TRUE), clipControl(hasClipControl)
{
  glGetIntegerv(GL_POLYGON_MODE, this->polygonMode);
  glGetIntegerv(GL_BLEND_EQUATION_RGB, &this->blendEquation[0]);
  glGetIntegerv(GL_BLEND_EQUATION_ALPHA, &this->blendEquation[1]);
  if (this->clipControl)
  {
    this->clipOrigin = getInteger(GL_CLIP_ORIGIN);
    this->clipDepth = getInteger(GL_CLIP_DEPTH_MODE);
  }
  // Who draws volumes of a parallel view switches it on; no other stage writes distances.
  glDisable(GL_CLIP_DISTANCE0);
  this->readTextures();
  vtkState->PushFramebufferBindings();
}

GLStateScope::~GLStateScope()
{
  this->state->PopFramebufferBindings();
  this->restoreTextures();
  glBindVertexArray(0);
  setEnabled(GL_COLOR_LOGIC_OP, this->logicOp);
  setEnabled(GL_DEPTH_CLAMP, this->depthClamp);
  setEnabled(GL_CLIP_DISTANCE0, this->clipDistance);
  setEnabled(GL_POLYGON_OFFSET_FILL, this->polygonOffset);
  glLogicOp(static_cast<GLenum>(this->logicOpMode));
  glClearStencil(this->stencilClear);
  glProvokingVertex(static_cast<GLenum>(this->provokingVertex));
  glFrontFace(static_cast<GLenum>(this->frontFace));
  // A core profile knows one mode for both faces.
  glPolygonMode(GL_FRONT_AND_BACK, static_cast<GLenum>(this->polygonMode[0]));
  this->state->vtkglBlendEquationSeparate(static_cast<GLenum>(this->blendEquation[0]),
                                          static_cast<GLenum>(this->blendEquation[1]));
  this->state->vtkglCullFace(static_cast<GLenum>(this->cullFaceMode));
  this->restoreStencil(GL_FRONT, this->front);
  this->restoreStencil(GL_BACK, this->back);
  if (this->clipControl)
  {
    glClipControl(static_cast<GLenum>(this->clipOrigin), static_cast<GLenum>(this->clipDepth));
  }
}

void GLStateScope::readTextures()
{
  for (unsigned int unit = 0; unit < unitsTaken; ++unit)
  {
    this->state->vtkglActiveTexture(GL_TEXTURE0 + unit);
    for (std::size_t kind = 0; kind < std::size(textureKinds); ++kind)
    {
      this->textures[unit][kind] = getInteger(textureKinds[kind].binding);
    }
  }
}

void GLStateScope::restoreTextures()
{
  for (unsigned int unit = 0; unit < unitsTaken; ++unit)
  {
    this->state->vtkglActiveTexture(GL_TEXTURE0 + unit);
    for (std::size_t kind = 0; kind < std::size(textureKinds); ++kind)
    {
      glBindTexture(textureKinds[kind].target, static_cast<GLuint>(this->textures[unit][kind]));
    }
  }
}

GLStateScope::StencilFace GLStateScope::readStencil(bool isFront)
{
  StencilFace values;
  values.func = getInteger(isFront ? GL_STENCIL_FUNC : GL_STENCIL_BACK_FUNC);
  values.reference = getInteger(isFront ? GL_STENCIL_REF : GL_STENCIL_BACK_REF);
  values.valueMask = getInteger(isFront ? GL_STENCIL_VALUE_MASK : GL_STENCIL_BACK_VALUE_MASK);
  values.writeMask = getInteger(isFront ? GL_STENCIL_WRITEMASK : GL_STENCIL_BACK_WRITEMASK);
  values.fail = getInteger(isFront ? GL_STENCIL_FAIL : GL_STENCIL_BACK_FAIL);
  values.depthFail = getInteger(isFront ? GL_STENCIL_PASS_DEPTH_FAIL : GL_STENCIL_BACK_PASS_DEPTH_FAIL);
  values.depthPass = getInteger(isFront ? GL_STENCIL_PASS_DEPTH_PASS : GL_STENCIL_BACK_PASS_DEPTH_PASS);
  return values;
}

void GLStateScope::restoreStencil(unsigned int face, const StencilFace& values)
{
  this->state->vtkglStencilFuncSeparate(face, static_cast<GLenum>(values.func), values.reference,
                                        static_cast<GLuint>(values.valueMask));
  this->state->vtkglStencilMaskSeparate(face, static_cast<GLuint>(values.writeMask));
  this->state->vtkglStencilOpSeparate(face, static_cast<GLenum>(values.fail),
                                      static_cast<GLenum>(values.depthFail),
                                      static_cast<GLenum>(values.depthPass));
}

} // namespace shadow
