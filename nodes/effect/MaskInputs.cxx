#include "MaskInputs.h"

#include <algorithm>
#include <tuple>

namespace shadow
{

bool MaskInputs::Way::operator==(const Way& other) const
{
  const auto values = [](const Way& way)
  {
    return std::tie(way.stencilMethod, way.silhouetteMethod, way.countBuffer, way.coplanarTolerance, way.samples,
                    way.viewSamples, way.findHiddenBacks);
  };
  return values(*this) == values(other);
}

bool MaskInputs::hasViewOf(const MaskInputs& other) const
{
  return this->way == other.way && this->clipFromWC == other.clipFromWC && this->width == other.width &&
         this->height == other.height && this->surfaces == other.surfaces;
}

KeptBits MaskInputs::findKept(const MaskInputs& before) const
{
  KeptBits kept;
  for (const Light& light : this->lights)
  {
    if (std::find(before.lights.begin(), before.lights.end(), light) != before.lights.end())
    {
      kept.inPlace |= 1u << static_cast<unsigned>(light.index);
      continue;
    }
    const auto same = std::find_if(before.lights.begin(), before.lights.end(), [&](const Light& other)
                                   { return other.positionWC == light.positionWC; });
    if (same != before.lights.end())
    {
      kept.moved.emplace_back(same->index, light.index);
    }
  }
  return kept;
}

} // namespace shadow
