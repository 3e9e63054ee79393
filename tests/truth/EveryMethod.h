#pragma once

#include <string>
#include <vector>

#include <vtkShadowVolumePass.h>

namespace shadow::truth
{

/// One way of making a shadow mask. All have to give the same.
struct ShadowMethod
{
  int silhouette;
  int countBuffer;
  int stencil;

  void use(vtkShadowVolumePass* pass) const
  {
    pass->SetSilhouetteMethod(this->silhouette);
    pass->SetCountBuffer(this->countBuffer);
    pass->SetStencilMethod(this->stencil);
  }

  std::string getName() const
  {
    const std::string stencilName = this->stencil == vtkShadowVolumePass::STENCIL_ZPASS   ? "ZPass"
                                    : this->stencil == vtkShadowVolumePass::STENCIL_ZFAIL ? "ZFail"
                                                                                          : "Auto";
    const std::string bufferName = this->countBuffer == vtkShadowVolumePass::COUNT_STENCIL ? "Stencil"
                                   : this->countBuffer == vtkShadowVolumePass::COUNT_COLOR ? "Color"
                                                                                           : "";
    return "Silhouette" + std::to_string(this->silhouette) + bufferName + stencilName;
  }
};

/// Every silhouette method by z-pass, z-fail and Auto; the first of them with both count buffers.
inline std::vector<ShadowMethod> everyMethod(vtkShadowVolumePass* pass)
{
  std::vector<ShadowMethod> methods;
  const int first = pass->GetSilhouetteMethodMinValue();
  for (int silhouette = first; silhouette <= pass->GetSilhouetteMethodMaxValue(); ++silhouette)
  {
    const std::vector<int> buffers =
        silhouette == first
            ? std::vector<int>{vtkShadowVolumePass::COUNT_STENCIL, vtkShadowVolumePass::COUNT_COLOR}
            : std::vector<int>{vtkShadowVolumePass::COUNT_AUTO};
    for (const int buffer : buffers)
    {
      for (const int stencil : {vtkShadowVolumePass::STENCIL_ZPASS, vtkShadowVolumePass::STENCIL_ZFAIL,
                                vtkShadowVolumePass::STENCIL_AUTO})
      {
        methods.push_back({silhouette, buffer, stencil});
      }
    }
  }
  return methods;
}

} // namespace shadow::truth
