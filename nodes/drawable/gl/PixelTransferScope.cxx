#include "PixelTransferScope.h"

#include "OpenGL.h"

namespace shadow
{

namespace
{

constexpr GLenum names[] = {GL_PACK_ALIGNMENT,    GL_PACK_ROW_LENGTH,    GL_PACK_SKIP_ROWS,
                            GL_PACK_SKIP_PIXELS,  GL_UNPACK_ALIGNMENT,   GL_UNPACK_ROW_LENGTH,
                            GL_UNPACK_SKIP_ROWS,  GL_UNPACK_SKIP_PIXELS, GL_UNPACK_IMAGE_HEIGHT,
                            GL_UNPACK_SKIP_IMAGES};

bool isAlignment(GLenum name)
{
  return name == GL_PACK_ALIGNMENT || name == GL_UNPACK_ALIGNMENT;
}

} // namespace

// Asked of the GL and given back to it behind vtkOpenGLState, which so never learns of the change.
PixelTransferScope::PixelTransferScope()
{
  static_assert(sizeof(names) / sizeof(names[0]) == settings);
  for (int i = 0; i < settings; ++i)
  {
    glGetIntegerv(names[i], &this->stores[i]);
    glPixelStorei(names[i], isAlignment(names[i]) ? 1 : 0);
  }
  glGetIntegerv(GL_PIXEL_PACK_BUFFER_BINDING, &this->packBuffer);
  glGetIntegerv(GL_PIXEL_UNPACK_BUFFER_BINDING, &this->unpackBuffer);
  glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
}

PixelTransferScope::~PixelTransferScope()
{
  for (int i = 0; i < settings; ++i)
  {
    glPixelStorei(names[i], this->stores[i]);
  }
  glBindBuffer(GL_PIXEL_PACK_BUFFER, static_cast<GLuint>(this->packBuffer));
  glBindBuffer(GL_PIXEL_UNPACK_BUFFER, static_cast<GLuint>(this->unpackBuffer));
}

} // namespace shadow
