#include "TexelArray.h"

#include <algorithm>
#include <cmath>

#include <vtkOpenGLState.h>

#include "OpenGL.h"
#include "PixelTransferScope.h"

namespace shadow
{

namespace
{

/// Beyond this a texture that is not split is no faster, and its last layer wastes more.
constexpr int usualSide = 4096;

struct FormatNames
{
  GLenum internal;
  GLenum pixel;
  GLenum type;
  int channels;
};

FormatNames namesOf(TexelFormat format)
{
  switch (format)
  {
  case TexelFormat::UInt1:
    return {GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, 1};
  case TexelFormat::UInt2:
    return {GL_RG32UI, GL_RG_INTEGER, GL_UNSIGNED_INT, 2};
  case TexelFormat::UInt4:
    return {GL_RGBA32UI, GL_RGBA_INTEGER, GL_UNSIGNED_INT, 4};
  case TexelFormat::Float1:
    return {GL_R32F, GL_RED, GL_FLOAT, 1};
  case TexelFormat::Float2:
    return {GL_RG32F, GL_RG, GL_FLOAT, 2};
  default:
    return {GL_RGBA32F, GL_RGBA, GL_FLOAT, 4};
  }
}

int getLimit(GLenum name)
{
  GLint value = 0;
  glGetIntegerv(name, &value);
  return value;
}

int countNeeded(std::size_t things, std::size_t each)
{
  return static_cast<int>((things + each - 1) / each);
}

/// Binds the texture of one unit, whichever is active, and puts back what was bound there.
class TextureBinding
{
public:
  explicit TextureBinding(unsigned int texture) : previous(getLimit(GL_TEXTURE_BINDING_2D_ARRAY))
  {
    glBindTexture(GL_TEXTURE_2D_ARRAY, texture);
  }
  ~TextureBinding() { glBindTexture(GL_TEXTURE_2D_ARRAY, static_cast<GLuint>(this->previous)); }
  TextureBinding(const TextureBinding&) = delete;
  TextureBinding& operator=(const TextureBinding&) = delete;

private:
  int previous;
};

} // namespace

bool TexelArray::allocate(std::size_t texels, std::string& error)
{
  const int most = getLimit(GL_MAX_TEXTURE_SIZE);
  const auto side =
      static_cast<std::size_t>(std::min(most, this->sideAskedFor > 0 ? this->sideAskedFor : usualSide));
  const auto mostLayers = static_cast<std::size_t>(getLimit(GL_MAX_ARRAY_TEXTURE_LAYERS));
  if (texels > side * side * mostLayers)
  {
    error = std::to_string(texels) + " texels are more than " + std::to_string(mostLayers) + " layers of " +
            std::to_string(side) + " x " + std::to_string(side) + " hold";
    this->release();
    return false;
  }
  // Nearly square, so that few texels are wasted; a power of two, where dividing by it is cheap.
  const double root = std::sqrt(static_cast<double>(std::max<std::size_t>(texels, 1)));
  const auto newWidth = std::min(side, static_cast<std::size_t>(std::exp2(std::ceil(std::log2(root)))));
  const int rows = std::max(1, countNeeded(texels, newWidth));
  // But the height is none, where there is room for a row more: llvmpipe compiles shaders that read textures
  // of one kind anew for those of the other.
  const bool isPower = (rows & (rows - 1)) == 0;
  const int newHeight = std::min(isPower ? std::max(rows + 1, 3) : rows, static_cast<int>(side));
  const int newLayers = countNeeded(static_cast<std::size_t>(rows), static_cast<std::size_t>(newHeight));
  const bool fits = this->texture != 0 && static_cast<int>(newWidth) == this->width &&
                    newHeight == this->height && newLayers == this->layers;
  if (!fits)
  {
    this->release();
    this->width = static_cast<int>(newWidth);
    this->height = newHeight;
    this->layers = newLayers;
  }
  this->size = texels;
  return fits || this->create(error);
}

bool TexelArray::create(std::string& error)
{
  const FormatNames names = namesOf(this->format);
  glGenTextures(1, &this->texture);
  const TextureBinding binding(this->texture);
  glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, static_cast<GLint>(names.internal), this->width, this->height,
               this->layers, 0, names.pixel, names.type, nullptr);
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAX_LEVEL, 0);
  GLint made = 0;
  glGetTexLevelParameteriv(GL_TEXTURE_2D_ARRAY, 0, GL_TEXTURE_WIDTH, &made);
  if (made != this->width)
  {
    glGetError(); // which says no more than this line
    error = "the GL refuses a texture of " + std::to_string(this->width) + " x " +
            std::to_string(this->height) + " texels in " + std::to_string(this->layers) + " layers";
    this->release();
    return false;
  }
  return true;
}

void TexelArray::upload(const void* texels, std::size_t first, std::size_t count)
{
  const TextureBinding binding(this->texture);
  const PixelTransferScope transfer;
  const auto* source = static_cast<const unsigned char*>(texels);
  const std::size_t texelBytes = 4u * static_cast<std::size_t>(this->getChannels());
  const auto row = static_cast<std::size_t>(this->width);
  while (count > 0)
  {
    // The rest of a row that was begun, else as many whole rows as the layer takes, else what is left.
    const std::size_t column = first % row;
    const std::size_t rowInLayer = first / row % static_cast<std::size_t>(this->height);
    const std::size_t rows = column == 0 && count >= row
                                 ? std::min(count / row, static_cast<std::size_t>(this->height) - rowInLayer)
                                 : 1;
    const std::size_t columns = rows > 1 ? row : std::min(count, row - column);
    this->uploadRows(source, first, static_cast<int>(columns), static_cast<int>(rows));
    const std::size_t done = rows * columns;
    source += done * texelBytes;
    first += done;
    count -= done;
  }
}

void TexelArray::uploadRows(const unsigned char* texels, std::size_t first, int columns, int rows) const
{
  const auto row = static_cast<std::size_t>(this->width);
  const auto layerRows = static_cast<std::size_t>(this->height);
  glTexSubImage3D(GL_TEXTURE_2D_ARRAY, 0, static_cast<GLint>(first % row),
                  static_cast<GLint>(first / row % layerRows), static_cast<GLint>(first / row / layerRows),
                  columns, rows, 1, this->getPixelFormat(), this->getPixelType(), texels);
}

void TexelArray::attachLayer(unsigned int target, int layer) const
{
  glFramebufferTextureLayer(target, GL_COLOR_ATTACHMENT0, this->texture, 0, layer);
}

void TexelArray::bind(vtkOpenGLState* state, unsigned int program, int unit, const char* sampler,
                      const char* layerSize) const
{
  state->vtkglActiveTexture(static_cast<GLenum>(GL_TEXTURE0 + unit));
  glBindTexture(GL_TEXTURE_2D_ARRAY, this->texture);
  glUniform1i(glGetUniformLocation(program, sampler), unit);
  glUniform2i(glGetUniformLocation(program, layerSize), this->width, this->height);
}

void TexelArray::bindImage(unsigned int unit) const
{
  glBindImageTexture(unit, this->texture, 0, GL_TRUE, 0, GL_WRITE_ONLY, namesOf(this->format).internal);
}

std::size_t TexelArray::getFirstOfLayer(int layer) const
{
  return static_cast<std::size_t>(layer) * static_cast<std::size_t>(this->width) *
         static_cast<std::size_t>(this->height);
}

std::size_t TexelArray::getCountOfLayer(int layer) const
{
  return std::min(this->getFirstOfLayer(layer + 1), this->size) - this->getFirstOfLayer(layer);
}

int TexelArray::getChannels() const
{
  return namesOf(this->format).channels;
}

unsigned int TexelArray::getPixelFormat() const
{
  return namesOf(this->format).pixel;
}

unsigned int TexelArray::getPixelType() const
{
  return namesOf(this->format).type;
}

std::size_t TexelArray::getMemorySize() const
{
  return 4u * static_cast<std::size_t>(this->getChannels()) * this->getFirstOfLayer(this->layers);
}

void TexelArray::release(bool contextLost)
{
  if (!contextLost && this->texture != 0)
  {
    glDeleteTextures(1, &this->texture);
  }
  this->texture = 0;
  this->size = 0;
  this->width = this->height = this->layers = 0;
}

} // namespace shadow
