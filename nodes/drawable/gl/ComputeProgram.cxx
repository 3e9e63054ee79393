#include "ComputeProgram.h"

#include <algorithm>
#include <vector>

#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLShaderCache.h>

#include "OpenGL.h"

namespace shadow
{

namespace
{

/// @param getParameter, getLog  glGetShader..., or glGetProgram... for a program
template <class GetParameter, class GetLog>
std::string readLog(GLuint object, GetParameter getParameter, GetLog getLog)
{
  GLint length = 0;
  getParameter(object, GL_INFO_LOG_LENGTH, &length);
  std::vector<GLchar> text(static_cast<std::size_t>(std::max(length, 1)), '\0');
  getLog(object, static_cast<GLsizei>(text.size()), nullptr, text.data());
  const std::string log = text.data();
  return log.substr(0, log.find_last_not_of(" \n") + 1);
}

} // namespace

bool ComputeProgram::use(vtkOpenGLRenderWindow* window, std::string& error)
{
  // Or VTK would go on believing that its program is the current one.
  window->GetShaderCache()->ReleaseCurrentShader();
  if (this->program == 0 && this->refusal.empty() && !this->build())
  {
    glDeleteProgram(this->program);
    this->program = 0;
  }
  if (this->program == 0)
  {
    error = std::string(this->name) + " " + this->refusal;
    return false;
  }
  glUseProgram(this->program);
  return true;
}

bool ComputeProgram::build()
{
  const GLuint shader = glCreateShader(GL_COMPUTE_SHADER);
  glShaderSource(shader, 1, &this->source, nullptr);
  glCompileShader(shader);
  GLint good = GL_FALSE;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
  if (good != GL_TRUE)
  {
    this->refusal = "does not compile: " + readLog(shader, glGetShaderiv, glGetShaderInfoLog);
    glDeleteShader(shader);
    return false;
  }
  this->program = glCreateProgram();
  glAttachShader(this->program, shader);
  glLinkProgram(this->program);
  glDetachShader(this->program, shader);
  glDeleteShader(shader);
  glGetProgramiv(this->program, GL_LINK_STATUS, &good);
  if (good != GL_TRUE)
  {
    this->refusal = "does not link: " + readLog(this->program, glGetProgramiv, glGetProgramInfoLog);
    return false;
  }
  GLint size[3] = {1, 1, 1};
  glGetProgramiv(this->program, GL_COMPUTE_WORK_GROUP_SIZE, size);
  this->groupSize = size[0] * size[1] * size[2];
  return true;
}

void ComputeProgram::useNone()
{
  glUseProgram(0);
}

void ComputeProgram::setInteger(const char* uniform, int value) const
{
  glUniform1i(glGetUniformLocation(this->program, uniform), value);
}

void ComputeProgram::setUnsigned(const char* uniform, unsigned int value) const
{
  glUniform1ui(glGetUniformLocation(this->program, uniform), value);
}

void ComputeProgram::setPair(const char* uniform, int x, int y) const
{
  glUniform2i(glGetUniformLocation(this->program, uniform), x, y);
}

void ComputeProgram::dispatch(std::size_t items) const
{
  if (items == 0)
  {
    return;
  }
  GLint most = this->groupsAskedFor;
  if (most == 0)
  {
    glGetIntegeri_v(GL_MAX_COMPUTE_WORK_GROUP_COUNT, 0, &most);
  }
  const auto size = static_cast<std::size_t>(this->groupSize);
  const std::size_t groups = (items + size - 1) / size;
  const std::size_t row = std::min(groups, static_cast<std::size_t>(most));
  const std::size_t rows = (groups + row - 1) / row;
  glDispatchCompute(static_cast<GLuint>(row), static_cast<GLuint>(rows), 1);
}

void ComputeProgram::release(bool contextLost)
{
  if (!contextLost && this->program != 0)
  {
    glDeleteProgram(this->program);
  }
  this->program = 0;
  this->refusal.clear();
}

} // namespace shadow
