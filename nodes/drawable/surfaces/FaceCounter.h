#pragma once

#include <cstddef>

#include "SEDGeode.h"
#include "View.h"

class vtkOpenGLState;
class vtkShaderProgram;

namespace shadow
{

/// Where the faces of shadow volumes are counted.
enum class CountBuffer
{
  Auto,    ///< Color on a software GL and where nothing bounds the count, else Stencil
  Stencil, ///< an 8-bit stencil buffer: counts modulo 256, and draws a face once for each time it counts
  Color    ///< a 32-bit float colour buffer with additive blending: counts to 2^24, and draws each face once
};

/// The most that a buffer can count before it must be looked at.
std::size_t mostCountableIn(CountBuffer buffer);

/// Whether volumes have to be cut at the near plane although depth clamp is on, which keeps their far ends: in
/// parallel views, by z-pass. Z-fail counts behind surfaces, which begin at the near plane themselves; there a
/// cut would only take from light caps the depth of the surfaces they lie on.
inline bool startsAtNear(const View& view, StencilCount count)
{
  return view.parallel && count == StencilCount::ZPass;
}

/// Sets the GL up so that the faces of shadow volumes that are drawn are counted: +1 for each that is
/// entered, -1 for each that is left, in front of the surface (z-pass) or the other way round behind it
/// (z-fail).
///
/// @par Source  Crow 1977; Heidmann 1991 (stencil); Roettger, Irion & Ertl 2002, "Shadow Volumes Revisited"
///              (blending)
class FaceCounter
{
public:
  /// What does not change between one volume and the next.
  struct Target
  {
    vtkOpenGLState* state = nullptr;
    vtkShaderProgram* program = nullptr;
    CountBuffer buffer = CountBuffer::Stencil; ///< not Auto
    bool reversedDepth = true;                 ///< see DepthRange
  };

  /// @param mirrored  a face wound counter-clockwise in model space is clockwise on the screen
  /// @pre  depth test on, depth mask off, ShadowTarget::beginCount() called
  FaceCounter(const Target& target, StencilCount count, bool mirrored);

  /// Has @p draw draw faces, as often as it takes to count each @p multiplicity times.
  ///
  /// @param draw    draws the same faces whenever it is called
  /// @param inward  the faces are wound clockwise seen from outside the volume
  template <class Draw>
  void count(int multiplicity, bool inward, const Draw& draw) const
  {
    this->setUp(multiplicity, inward);
    for (int time = 0; time < this->getDraws(multiplicity); ++time)
    {
      draw();
    }
  }

  /// How often count() draws.
  int getDraws(int multiplicity) const
  {
    return this->target.buffer == CountBuffer::Stencil ? multiplicity : 1;
  }

  vtkShaderProgram* getProgram() const { return this->target.program; }
  bool isDepthReversed() const { return this->target.reversedDepth; }

private:
  void setUp(int multiplicity, bool inward) const;

  Target target;
  StencilCount stencilCount;
  bool mirrored;
};

} // namespace shadow
