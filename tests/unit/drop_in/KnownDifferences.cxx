#include "DropInCase.h"

namespace shadow::test
{

// What cannot be avoided, of 19,200 pixels.
const std::vector<KnownDifference>& knownDifferences()
{
  static const std::vector<KnownDifference> list{
      {NoCasters,
       449,
       "VTK switches the depth test on where it erases. Without it, what is drawn last is seen, and the mask is "
       "that of what is nearest",
       {"erase_off", "window_erase_off"}},
      {NoCasters,
       1,
       "edges as tubes have normals of their own, which look towards lights that their face does not",
       {"edges_as_tubes"}},
      {NoCasters,
       1,
       "a sample at the rim, where front and back of a ball meet within rounding of depth: none with Mesa 22, "
       "by a fifth of the pixel's light with Mesa 26",
       {"multisampled", "multisampled_wires", "multisampled_glass"}},
  };
  return list;
}

} // namespace shadow::test
