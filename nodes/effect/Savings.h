#pragma once

namespace shadow
{

/// Work that a frame may leave out, where that is sure to give the same picture. Flags, to be added up;
/// vtkShadowVolumePass has the same.
enum Savings : int
{
  NoSavings = 0,
  KeptMasks = 1, ///< the shadow mask is taken over, or the bits of those lights that it still is right for
  Batches = 2,   ///< small meshes are drawn together, see SurfaceBatch
  Scissor = 4,   ///< volumes are counted where surfaces are seen only
  AllSavings = KeptMasks | Batches | Scissor
};

} // namespace shadow
