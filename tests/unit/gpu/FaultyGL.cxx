#include "FaultyGL.h"

#include "OpenGL.h"

namespace
{

std::string rightText;
std::string wrongText;
int altered = 0;
decltype(glShaderSource) giveSource = nullptr;

void GLAPIENTRY giveWrongSource(GLuint shader, GLsizei count, const GLchar* const* strings,
                                const GLint* lengths)
{
  std::string text;
  for (GLsizei i = 0; i < count; ++i)
  {
    const bool ended = lengths == nullptr || lengths[i] < 0;
    text += ended ? std::string(strings[i]) : std::string(strings[i], static_cast<std::size_t>(lengths[i]));
  }
  std::size_t place = text.find(rightText);
  altered += place != std::string::npos ? 1 : 0;
  for (; place != std::string::npos; place = text.find(rightText, place + wrongText.size()))
  {
    text.replace(place, rightText.size(), wrongText);
  }
  const GLchar* all = text.c_str();
  giveSource(shader, 1, &all, nullptr);
}

decltype(glDrawElementsIndirect) drawIndirect = nullptr;

void GLAPIENTRY drawNothing(GLenum, GLenum, const void*) {}

decltype(glStencilOpSeparate) setStencil = nullptr;

void GLAPIENTRY keepStencil(GLenum face, GLenum, GLenum, GLenum)
{
  setStencil(face, GL_KEEP, GL_KEEP, GL_KEEP);
}

} // namespace

namespace shadow::test
{

FaultyShaders::FaultyShaders(const std::string& text, const std::string& other)
{
  rightText = text;
  wrongText = other;
  altered = 0;
  giveSource = glShaderSource;
  glShaderSource = &giveWrongSource;
}

FaultyShaders::~FaultyShaders()
{
  glShaderSource = giveSource;
}

int FaultyShaders::countAltered() const
{
  return altered;
}

LostIndirectDraws::LostIndirectDraws()
{
  drawIndirect = glDrawElementsIndirect;
  glDrawElementsIndirect = &drawNothing;
}

LostIndirectDraws::~LostIndirectDraws()
{
  glDrawElementsIndirect = drawIndirect;
}

LostStencilCounts::LostStencilCounts()
{
  setStencil = glStencilOpSeparate;
  glStencilOpSeparate = &keepStencil;
}

LostStencilCounts::~LostStencilCounts()
{
  glStencilOpSeparate = setStencil;
}

} // namespace shadow::test
