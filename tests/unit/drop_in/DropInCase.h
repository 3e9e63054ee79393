#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

#include <vtkRenderPass.h>

#include "DropInScene.h"

namespace shadow::test
{

/// Hangs the pass that draws the scene into a renderer, below whatever the row is about.
/// @param ours  nullptr: VTK's own instead
using Attach = std::function<void(vtkRenderer* renderer, vtkRenderPass* ours)>;

/// How a scene is drawn with a pass that has nothing to add to it.
enum Way : unsigned
{
  Mask = 1,              ///< vtkShadowVolumePass, ShadowIntensity 0
  Additive = 2,          ///< the same, with a pass for each light
  NoCasters = 4,         ///< vtkShadowVolumePass, no prop casts
  LinesOff = 8,          ///< vtkSilhouettePass, all three kinds of edges off
  LinesOffOverMask = 16, ///< the same, over a vtkShadowVolumePass with ShadowIntensity 0
  Selecting = 32,        ///< not drawn, but selected in, with either pass
  Shadowed = 64          ///< vtkShadowVolumePass as it is: the law holds where all lights reach
};
inline constexpr unsigned everyWay =
    Mask | Additive | NoCasters | LinesOff | LinesOffOverMask | Selecting | Shadowed;
/// All but the one that rounds for each light, which filters may enlarge.
inline constexpr unsigned wholeWays = everyWay & ~Additive;
/// Where pixels depend on others around them: filters carry shadows on.
inline constexpr unsigned filteredWays = wholeWays & ~Shadowed;
const char* toString(Way way);

/// One row of the table: a scene that must look the same with our passes as without.
struct Row
{
  std::string name; ///< letters, digits and underscores
  std::function<void(DropInScene&)> build;
  Attach attach = nullptr;  ///< none: ours is the renderer's pass, and VTK's own is none
  unsigned ways = everyWay; ///< to draw it
};
std::ostream& operator<<(std::ostream& os, const Row& row);

/// What a window shows: all that can be read of it.
struct Picture
{
  Pixels colour;            ///< RGBA, bottom row first, and then what tiles were put together to
  std::vector<float> depth; ///< as many as pixels
};

/// The first picture of a scene and the second, for which all has been made ready.
using Pictures = std::array<Picture, 2>;

/// Draws a row's scene, built anew.
/// @param way   nullptr: VTK alone
/// @param flat  shade all actors flat. A surface that looks away from a light is dark in a mask without
/// casters as well, where VTK may light it by normals that were smoothed.
Pictures draw(const Row& row, const Way* way, bool flat = false);

/// A row's scene with shadows.
/// @param plain  VTK alone
/// @return the picture, with the colour of VTK's where a light's mask tells that it does not reach a pixel,
///         or not all of it; all VTK's where it is made of several views, which have masks of their own
Picture drawShadowed(const Row& row, const Picture& plain);

/// The second picture of a row's scene when the first was drawn with a pass, which was taken off.
Picture drawAfter(const Row& row, Way way);

/// How many roundings to 1 / 255 set an additive picture of a row's scene apart from VTK's: one for each light
/// that is switched on, at least one as VTK makes one where none is, and one for the mean of several samples.
int countRoundings(const Row& row);

/// How many pixels two pictures differ in, and by how much at most.
struct Difference
{
  std::size_t colour = 0; ///< pixels that differ in red, green or blue by more than a tolerance
  std::size_t alpha = 0;
  std::size_t depth = 0;
  int largest = 0; ///< of red, green, blue and alpha

  bool none() const { return this->colour + this->alpha + this->depth == 0; }
};
std::ostream& operator<<(std::ostream& os, const Difference& difference);

/// @param tolerance  of red, green and blue, in 1 / 255
Difference compare(const Picture& a, const Picture& b, int tolerance = 0);

/// What is found at pixels of a row's scene: prop and cell for each that a hardware selector covers, or props
/// alone on a coarse grid where a row picks from some only.
/// @param way  nullptr: VTK alone
std::vector<int> pick(const Row& row, const Way* way);

/// Rows that the law holds for but in a few pixels, for one cause.
struct KnownDifference
{
  unsigned ways;      ///< of these; the law is asserted for the others
  std::size_t pixels; ///< that may differ in colour, at most
  const char* cause;
  std::vector<std::string> rows;
};
const std::vector<KnownDifference>& knownDifferences();

std::vector<Row> surfaceRows();
std::vector<Row> translucentRows();
std::vector<Row> propRows();
std::vector<Row> overlayRows();
std::vector<Row> settingRows();
std::vector<Row> windowRows();
std::vector<Row> treeRows();   ///< ours among VTK's passes
std::vector<Row> filterRows(); ///< below VTK's passes that work on the picture

} // namespace shadow::test
