#pragma once

#include <array>
#include <vector>

#include "ShadowVolume.h"

namespace shadow
{

/// How faces of a volume are counted.
struct FaceKind
{
  int multiplicity;
  bool inward; ///< clockwise seen from outside
  bool side;   ///< see depthBias()
};

/// Faces of a ShadowVolume, or of its ClosePart, that are counted in one way.
template <class Owner>
struct FacesOf
{
  std::vector<ShadowVolume::Triangle> Owner::*triangles;
  FaceKind kind;
};

inline constexpr std::array<FacesOf<ShadowVolume>, 6> volumeFaces = {
    {{&ShadowVolume::sides, {1, false, true}},
     {&ShadowVolume::doubledSides, {2, false, true}},
     {&ShadowVolume::lightCap, {1, false, false}},
     {&ShadowVolume::darkCap, {1, false, false}},
     {&ShadowVolume::doubledDarkCap, {2, false, false}},
     {&ShadowVolume::lightCapReversed, {1, true, false}}}};

inline constexpr std::array<FacesOf<ShadowVolume::ClosePart>, 3> closeFaces = {
    {{&ShadowVolume::ClosePart::sides, {1, false, true}},
     {&ShadowVolume::ClosePart::doubledSides, {2, false, true}},
     {&ShadowVolume::ClosePart::darkCap, {1, false, false}}}};

} // namespace shadow
