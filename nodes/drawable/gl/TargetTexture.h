#pragma once

namespace shadow
{

/// GL_TEXTURE_2D_MULTISAMPLE for more than one sample a pixel, else GL_TEXTURE_2D.
unsigned int textureTargetOf(int samples);

/// A texture to draw into and to look texels up in, one level, not filtered. With several samples a pixel they
/// are at fixed places, as those of renderbuffers are: without, no framebuffer may have both.
///
/// @param format,type  of pixels that could be uploaded to @p internalFormat; none are
/// @post  what was bound is bound again
unsigned int makeTargetTexture(int width, int height, int samples, unsigned int internalFormat,
                               unsigned int format, unsigned int type);

} // namespace shadow
