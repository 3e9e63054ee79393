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

/// Where a pass stands in a tree of passes.
struct Place
{
  bool found = false;
  bool othersBeside = false; ///< others beside it, or beside a pass above it, draw what is not opaque
  bool camera = false;       ///< a pass above it sets viewport and background
  bool drawnBefore = false;  ///< a pass before it in a sequence has drawn something
};

class PassSearch
{
public:
  explicit PassSearch(vtkRenderPass* thePass) : pass(thePass) {}

  /// Looks for the pass in a tree, whose root has @p place but for Place::found.
  Place find(vtkRenderPass* tree, Place place)
  {
    if (tree == nullptr || !this->visited.insert(tree).second)
    {
      return {};
    }
    if (tree == this->pass)
    {
      place.found = true;
      return place;
    }
    if (auto* steps = vtkRenderStepsPass::SafeDownCast(tree))
    {
      place.camera = place.camera || steps->GetCameraPass() != nullptr;
      Place below = place;
      below.othersBeside = true;
      const Place opaque = this->find(steps->GetOpaquePass(), below);
      return opaque.found ? opaque : this->find(steps->GetPostProcessPass(), place);
    }
    if (auto* sequence = vtkSequencePass::SafeDownCast(tree))
    {
      return this->findIn(sequence->GetPasses(), place);
    }
    // A filter has a framebuffer of its own, which is as it made it.
    const bool filters = tree->IsA("vtkSSAAPass") != 0 || tree->IsA("vtkImageProcessingPass") != 0;
    const bool setsCamera = tree->IsA("vtkCameraPass") != 0 || tree->IsA("vtkSilhouettePass") != 0;
    place.camera = !filters && (place.camera || setsCamera);
    place.drawnBefore = !filters && place.drawnBefore;
    return this->find(delegateOf(tree), place);
  }

private:
  Place findIn(vtkRenderPassCollection* passes, Place place)
  {
    const int count = passes != nullptr ? passes->GetNumberOfItems() : 0;
    for (int i = 0; i < count; ++i)
    {
      place.othersBeside =
          place.othersBeside || drawsTheRest(vtkRenderPass::SafeDownCast(passes->GetItemAsObject(i)));
    }
    for (int i = 0; i < count; ++i)
    {
      auto* item = vtkRenderPass::SafeDownCast(passes->GetItemAsObject(i));
      const Place found = this->find(item, place);
      if (found.found)
      {
        return found;
      }
      place.drawnBefore = place.drawnBefore || (item != nullptr && item->IsA("vtkLightsPass") == 0);
    }
    return {};
  }

  static vtkRenderPass* delegateOf(vtkRenderPass* above)
  {
    if (auto* camera = vtkCameraPass::SafeDownCast(above))
    {
      return camera->GetDelegatePass();
    }
    if (auto* supersampling = vtkSSAAPass::SafeDownCast(above))
    {
      return supersampling->GetDelegatePass();
    }
    if (auto* outlines = vtkSilhouettePass::SafeDownCast(above))
    {
      return outlines->GetDelegatePass();
    }
    auto* image = vtkImageProcessingPass::SafeDownCast(above);
    return image != nullptr ? image->GetDelegatePass() : nullptr;
  }

  vtkRenderPass* pass;
  std::set<vtkRenderPass*> visited; ///< passes that users connect may go round in circles
};

} // namespace

bool othersDrawTheRest(vtkRenderer* renderer, vtkRenderPass* pass)
{
  return PassSearch(pass).find(renderer->GetPass(), {}).othersBeside;
}

CameraNeed findCameraNeed(vtkRenderer* renderer, vtkRenderPass* pass)
{
  const Place place = PassSearch(pass).find(renderer->GetPass(), {});
  if (!place.found || place.othersBeside || place.camera)
  {
    return CameraNeed::None;
  }
  return place.drawnBefore ? CameraNeed::Viewport : CameraNeed::All;
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
