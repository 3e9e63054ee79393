#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "FacingBits.h"
#include "Light.h"
#include "TexelArray.h"
#include "TexelPainter.h"
#include "TexelReadBack.h"
#include "VETCollection.h"

class vtkOpenGLRenderWindow;

namespace shadow
{

class TriangleDrawable;

/// A camera that renders to a texture which lights every triangle of a scene faces: one texel a triangle, all
/// lights at once.
///
/// Texel t is triangle t of the VETCollection. Bit i of x: light i (by Light::index) is in front of the
/// oriented triangle; bit i of y: behind it; neither: in its plane, or a point light at one of its corners,
/// or no such light. A light is at a corner when single precision cannot tell them apart, seen from the
/// triangle.
///
/// Numbers have 48 bits, see shaders/facing.glsl, so that signs may differ from computeFacing() only for a
/// light that is nearer to the plane than about 1e-13 of its distance. As each triangle is decided once,
/// silhouettes are closed all the same.
///
/// @par Source  Shi 2006, chapters 3.3 (improved method) and 4.3
class SilhouetteCamera
{
public:
  /// @param maximumSide  see TexelArray
  explicit SilhouetteCamera(int maximumSide = 0) : texels(TexelFormat::UInt2, maximumSide) {}
  SilhouetteCamera(const SilhouetteCamera&) = delete;
  SilhouetteCamera& operator=(const SilhouetteCamera&) = delete;

  /// Draws the texture. Lights that are not finite have no bits.
  ///
  /// @param triangles  as uploaded for the coming frame
  /// @param lights     at most maximumLights, each with another index
  /// @return  false with a line in @p error when the GL cannot
  /// @post    GL is as it was
  /// @par Cost  O(triangles * lights)
  bool draw(vtkOpenGLRenderWindow* window, TriangleDrawable& triangles, const std::vector<Light>& lights,
            std::string& error);

  /// Asks for a copy of the texture in main memory, and returns at once where the GL allows.
  /// @pre  draw() has succeeded
  void startReadBack(vtkOpenGLRenderWindow* window) { this->readBack.start(getState(window), this->texels); }

  /// Waits for the copy. @return false when there is none
  bool fetch() { return this->readBack.fetch(this->words); }

  /// What startReadBack() and fetch() cost; drawing is in there only as far as the GPU has not yet done it:
  /// to tell them apart, call glFinish() after draw().
  const ReadBackTimes& getReadBackTimes() const { return this->readBack.getTimes(); }

  /// The fetched facing of one geode under one path towards one light: as computeFacing() has it, up to the
  /// rounding named above.
  /// @param light  one of those that were drawn
  /// @param facing  overwritten; keeps the memory it has
  /// @pre   fetch() has succeeded, and the collection has not changed since draw()
  /// @par Cost  O(triangles), about 1 ns a triangle
  void getFacing(const VETRange& range, const Light& light, LightFacing& facing) const;

  const TexelArray& getTexels() const { return this->texels; }

  /// Frees the GL objects. @pre their context is current, or is gone and @p contextLost
  void release(bool contextLost = false);

  std::size_t getMemorySize() const; ///< bytes on the GPU

private:
  static class vtkOpenGLState* getState(vtkOpenGLRenderWindow* window);

  TexelArray texels;
  TexelPainter painter;
  TexelReadBack readBack;
  std::vector<std::uint32_t> words; ///< two a triangle
};

} // namespace shadow
