#include "PassScope.h"

#include <vtkCameraPass.h>
#include <vtkImageProcessingPass.h>
#include <vtkRenderPassCollection.h>
#include <vtkRenderStepsPass.h>
#include <vtkRenderer.h>
#include <vtkSSAAPass.h>
#include <vtkSequencePass.h>

#include "vtkSilhouettePass.h"

namespace shadow
{

namespace
{

bool drawsTheRest(vtkRenderPass* pass)
{
  return pass->IsA("vtkTranslucentPass") != 0 || pass->IsA("vtkVolumetricPass") != 0 ||
         pass->IsA("vtkOverlayPass") != 0 || pass->IsA("vtkDepthPeelingPass") != 0 ||
         pass->IsA("vtkDualDepthPeelingPass") != 0;
}

// True when @p pass is found below @p tree with others beside it that draw the rest.
bool search(vtkRenderPass* tree, vtkRenderPass* pass, bool othersBeside)
{
  if (tree == nullptr)
  {
    return false;
  }
  if (tree == pass)
  {
    return othersBeside;
  }
  if (auto* steps = vtkRenderStepsPass::SafeDownCast(tree))
  {
    return search(steps->GetOpaquePass(), pass, true) ||
           search(steps->GetPostProcessPass(), pass, othersBeside);
  }
  if (auto* sequence = vtkSequencePass::SafeDownCast(tree))
  {
    vtkRenderPassCollection* passes = sequence->GetPasses();
    bool beside = othersBeside;
    for (int i = 0; passes != nullptr && i < passes->GetNumberOfItems(); ++i)
    {
      beside = beside || drawsTheRest(vtkRenderPass::SafeDownCast(passes->GetItemAsObject(i)));
    }
    for (int i = 0; passes != nullptr && i < passes->GetNumberOfItems(); ++i)
    {
      if (search(vtkRenderPass::SafeDownCast(passes->GetItemAsObject(i)), pass, beside))
      {
        return true;
      }
    }
    return false;
  }
  if (auto* camera = vtkCameraPass::SafeDownCast(tree))
  {
    return search(camera->GetDelegatePass(), pass, othersBeside);
  }
  if (auto* supersampling = vtkSSAAPass::SafeDownCast(tree))
  {
    return search(supersampling->GetDelegatePass(), pass, othersBeside);
  }
  if (auto* outlines = vtkSilhouettePass::SafeDownCast(tree))
  {
    return search(outlines->GetDelegatePass(), pass, othersBeside);
  }
  if (auto* image = vtkImageProcessingPass::SafeDownCast(tree))
  {
    return search(image->GetDelegatePass(), pass, othersBeside);
  }
  return false;
}

} // namespace

bool othersDrawTheRest(vtkRenderer* renderer, vtkRenderPass* pass)
{
  return search(renderer->GetPass(), pass, false);
}

} // namespace shadow
