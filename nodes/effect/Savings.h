#pragma once

namespace shadow
{

/// What a frame may take over from the one before, where that is sure to give the same picture. Flags, to be
/// added up; vtkShadowVolumePass has the same.
enum Savings : int
{
  NoSavings = 0,
  KeptMasks = 1, ///< the shadow mask, or the bits of those lights that it still is right for
  AllSavings = KeptMasks
};

} // namespace shadow
