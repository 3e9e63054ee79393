#include "PassScope.h"

#include <set>

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
// @param visited  where the search has been: passes that users connect may go round in circles
bool search(vtkRenderPass* tree, vtkRenderPass* pass, bool othersBeside, std::set<vtkRenderPass*>& visited)
{
  if (tree == nullptr || !visited.insert(tree).second)
  {
    return false;
  }
  if (tree == pass)
  {
    return othersBeside;
  }
  if (auto* steps = vtkRenderStepsPass::SafeDownCast(tree))
  {
    return search(steps->GetOpaquePass(), pass, true, visited) ||
           search(steps->GetPostProcessPass(), pass, othersBeside, visited);
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
      if (search(vtkRenderPass::SafeDownCast(passes->GetItemAsObject(i)), pass, beside, visited))
      {
        return true;
      }
    }
    return false;
  }
  if (auto* camera = vtkCameraPass::SafeDownCast(tree))
  {
    return search(camera->GetDelegatePass(), pass, othersBeside, visited);
  }
  if (auto* supersampling = vtkSSAAPass::SafeDownCast(tree))
  {
    return search(supersampling->GetDelegatePass(), pass, othersBeside, visited);
  }
  if (auto* outlines = vtkSilhouettePass::SafeDownCast(tree))
  {
    return search(outlines->GetDelegatePass(), pass, othersBeside, visited);
  }
  if (auto* image = vtkImageProcessingPass::SafeDownCast(tree))
  {
    return search(image->GetDelegatePass(), pass, othersBeside, visited);
  }
  return false;
}

} // namespace

bool othersDrawTheRest(vtkRenderer* renderer, vtkRenderPass* pass)
{
  std::set<vtkRenderPass*> visited;
  return search(renderer->GetPass(), pass, false, visited);
}

bool hasNoPixels(vtkRenderer* renderer)
{
  int width = 0;
  int height = 0;
  int left = 0;
  int bottom = 0;
  renderer->GetTiledSizeAndOrigin(&width, &height, &left, &bottom);
  return width <= 0 || height <= 0;
}

} // namespace shadow
