#include "DropInCase.h"

namespace shadow::test
{

// ROWS THAT ARE SWITCHED OFF, by what breaks the law there and by how much, of 19,200 pixels. With
// SHADOW_TEST_SWITCHED_OFF in the environment they are tested all the same, and tell how many pixels differ.
const std::vector<KnownDifference>& knownDifferences()
{
  static const std::vector<KnownDifference> list{
      {NoCasters,
       "449 px: VTK switches the depth test on where it erases. Without it, what is drawn last is seen, and "
       "the mask is that of what is nearest",
       {"erase_off", "window_erase_off"}},
      {NoCasters,
       "1 px: edges as tubes have normals of their own, which look towards lights that their face does not",
       {"edges_as_tubes"}},
  };
  return list;
}

} // namespace shadow::test
