#pragma once

#include <string>
#include <vector>

#include <vtkShadowVolumePass.h>

#include "SilhouetteFinder.h"

namespace shadow::test
{

/// Every vtkShadowVolumePass::SilhouetteMethods.
inline std::vector<int> allMethods(vtkShadowVolumePass* pass)
{
  std::vector<int> methods;
  for (int method = pass->GetSilhouetteMethodMinValue(); method <= pass->GetSilhouetteMethodMaxValue();
       ++method)
  {
    methods.push_back(method);
  }
  return methods;
}

inline std::string nameOf(int method)
{
  return toString(static_cast<SilhouetteMethod>(method));
}

} // namespace shadow::test
