#pragma once

#include <cstddef>
#include <string>

class vtkOpenGLState;

namespace shadow
{

/// What a texel of a TexelArray holds; 32 bits a channel.
enum class TexelFormat
{
  UInt1,
  UInt2,
  UInt4,
  Float1,
  Float2,
  Float4
};

/// Any number of texels on the GPU, to be looked up by index: a GL_TEXTURE_2D_ARRAY whose rows and layers
/// they fill one after the other, since a GL limits each. Shaders find texel i by shaders/texelArray.glsl.
class TexelArray
{
public:
  /// @param maximumSide  texels in a row and rows in a layer, at most; 0: what the GL allows, up to 4096
  explicit TexelArray(TexelFormat texelFormat, int maximumSide = 0)
      : format(texelFormat), sideAskedFor(maximumSide)
  {
  }
  TexelArray(const TexelArray&) = delete;
  TexelArray& operator=(const TexelArray&) = delete;

  /// Makes room for this many texels; nothing is kept, unless the room is there already.
  /// @return false with a line in @p error, and no texels, when the GL has no room for them
  bool allocate(std::size_t texels, std::string& error);

  /// Replaces texels @p first to @p first + @p count - 1.
  /// @param texels  count times as many 4-byte values as the format has channels
  /// @pre   allocate() has made room for them
  void upload(const void* texels, std::size_t first, std::size_t count);

  /// Attaches a layer as colour attachment 0 of the framebuffer bound to @p target (GL_DRAW_FRAMEBUFFER,
  /// GL_READ_FRAMEBUFFER or GL_FRAMEBUFFER).
  void attachLayer(unsigned int target, int layer) const;

  /// Binds the texels to a texture unit, and sets the program's sampler and the ivec2 that texelArray.glsl
  /// takes. @param program  name of a GL program that is current; a uniform that it lacks is left out
  void bind(vtkOpenGLState* state, unsigned int program, int unit, const char* sampler,
            const char* layerSize) const;

  /// Binds all layers to an image unit, for a shader to write them. @pre GL 4.2
  void bindImage(unsigned int unit) const;

  unsigned int getTexture() const { return this->texture; } ///< GL_TEXTURE_2D_ARRAY; 0 before allocate()
  std::size_t getSize() const { return this->size; }        ///< texels
  int getWidth() const { return this->width; }              ///< texels in a row
  int getHeight() const { return this->height; }            ///< rows in a layer
  int getLayers() const { return this->layers; }
  std::size_t getFirstOfLayer(int layer) const; ///< index of the layer's first texel
  std::size_t getCountOfLayer(int layer) const; ///< texels of the layer in use
  int getChannels() const;
  unsigned int getPixelFormat() const; ///< as glReadPixels() takes it
  unsigned int getPixelType() const;
  std::size_t getMemorySize() const;

  /// Frees the GL objects. @pre their context is current, or is gone and @p contextLost
  void release(bool contextLost = false);

private:
  bool create(std::string& error);
  void uploadRows(const unsigned char* texels, std::size_t first, int columns, int rows) const;

  TexelFormat format;
  int sideAskedFor;
  unsigned int texture = 0;
  std::size_t size = 0;
  int width = 0;
  int height = 0;
  int layers = 0;
};

} // namespace shadow
