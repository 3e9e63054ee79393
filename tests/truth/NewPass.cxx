#include "NewPass.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include <vtkAssemblyNode.h>
#include <vtkAssemblyPath.h>
#include <vtkNew.h>
#include <vtkProp.h>
#include <vtkPropCollection.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>
#include <vtkShadowVolumePass.h>

#include "Pixels.h"

namespace shadow::truth
{

namespace
{

std::vector<vtkRenderer*> renderersOf(vtkRenderWindow* window, const vtkShadowVolumePass* pass)
{
  std::vector<vtkRenderer*> renderers;
  vtkCollectionSimpleIterator iterator;
  window->GetRenderers()->InitTraversal(iterator);
  while (vtkRenderer* renderer = window->GetRenderers()->GetNextRenderer(iterator))
  {
    if (renderer->GetPass() == pass)
    {
      renderers.push_back(renderer);
    }
  }
  return renderers;
}

void copyCasting(vtkRenderer* renderer, vtkShadowVolumePass* from, vtkShadowVolumePass* to)
{
  vtkCollectionSimpleIterator iterator;
  renderer->GetViewProps()->InitTraversal(iterator);
  while (vtkProp* prop = renderer->GetViewProps()->GetNextProp(iterator))
  {
    prop->InitPathTraversal();
    while (vtkAssemblyPath* path = prop->GetNextPath())
    {
      vtkCollectionSimpleIterator nodes;
      path->InitTraversal(nodes);
      while (vtkAssemblyNode* node = path->GetNextNode(nodes))
      {
        to->SetCasting(node->GetViewProp(), from->GetCasting(node->GetViewProp()));
      }
    }
  }
}

void copySettings(vtkShadowVolumePass* from, vtkShadowVolumePass* to)
{
  to->SetStencilMethod(from->GetStencilMethod());
  to->SetCountBuffer(from->GetCountBuffer());
  to->SetSilhouetteMethod(from->GetSilhouetteMethod());
  to->SetCoplanarTolerance(from->GetCoplanarTolerance());
  to->SetCompositing(from->GetCompositing());
  to->SetShadowIntensity(from->GetShadowIntensity());
  to->SetSamples(from->GetSamples());
  to->SetWeldTolerance(from->GetWeldTolerance());
  to->SetScope(from->GetScope());
}

} // namespace

DrawnShadows drawShadows(vtkRenderWindow* window, vtkShadowVolumePass* pass)
{
  DrawnShadows drawn;
  window->Render();
  drawn.status = pass->GetStatus();
  drawn.message = pass->GetStatusMessage();
  drawn.counts = {pass->GetNumberOfShadowLights(), pass->GetNumberOfCasters(), pass->GetNumberOfZFailCasters(),
                  pass->GetNumberOfSkippedCasters(), pass->GetPrePassTriangles(), pass->GetSideTriangles(),
                  pass->GetCapTriangles(), pass->GetSilhouetteEdges()};
  const bool hasMasks =
      !renderersOf(window, pass).empty() && drawn.status <= vtkShadowVolumePass::STATUS_PARTIAL;
  for (Pixels mask = hasMasks ? readMask(pass, 0) : Pixels(); !mask.empty();
       mask = readMask(pass, static_cast<int>(drawn.masks.size())))
  {
    drawn.masks.push_back(std::move(mask));
  }
  drawn.picture = readPicture(window);
  return drawn;
}

DrawnShadows drawByNewPass(vtkRenderWindow* window, vtkShadowVolumePass* pass)
{
  vtkNew<vtkShadowVolumePass> fresh;
  copySettings(pass, fresh);
  fresh->SetSavings(vtkShadowVolumePass::SAVINGS_NONE);
  const std::vector<vtkRenderer*> renderers = renderersOf(window, pass);
  for (vtkRenderer* renderer : renderers)
  {
    copyCasting(renderer, pass, fresh);
    renderer->SetPass(fresh);
  }
  DrawnShadows drawn = drawShadows(window, fresh);
  for (vtkRenderer* renderer : renderers)
  {
    renderer->SetPass(pass);
  }
  return drawn;
}

std::string tellDifferences(const DrawnShadows& one, const DrawnShadows& other)
{
  std::string text;
  if (one.status != other.status || one.message != other.message)
  {
    text += "status " + std::to_string(one.status) + " '" + one.message + "' and " +
            std::to_string(other.status) + " '" + other.message + "'\n";
  }
  for (std::size_t i = 0; i < one.counts.size(); ++i)
  {
    if (one.counts[i] != other.counts[i])
    {
      text += std::to_string(one.counts[i]) + " and " + std::to_string(other.counts[i]) + " in count " +
              std::to_string(i) + "\n";
    }
  }
  if (one.masks.size() != other.masks.size())
  {
    text += std::to_string(one.masks.size()) + " and " + std::to_string(other.masks.size()) + " masks\n";
  }
  for (std::size_t light = 0; light < std::min(one.masks.size(), other.masks.size()); ++light)
  {
    if (const std::size_t different = countDifferent(one.masks[light], other.masks[light]))
    {
      text += std::to_string(different) + " pixels of the mask of light " + std::to_string(light) + "\n";
    }
  }
  if (const std::size_t different = countDifferent(one.picture, other.picture))
  {
    text += std::to_string(different) + " values of the picture\n";
  }
  return text;
}

} // namespace shadow::truth
