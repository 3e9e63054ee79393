#include "NewPass.h"

#include <algorithm>
#include <cstddef>

#include <vtkAssemblyNode.h>
#include <vtkAssemblyPath.h>
#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkLightCollection.h>
#include <vtkNew.h>
#include <vtkProp.h>
#include <vtkPropCollection.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>
#include <vtkShadowVolumePass.h>
#include <vtkUnsignedCharArray.h>

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

int countLights(vtkRenderer* renderer)
{
  int on = 0;
  vtkCollectionSimpleIterator iterator;
  renderer->GetLights()->InitTraversal(iterator);
  while (vtkLight* light = renderer->GetLights()->GetNextLight(iterator))
  {
    on += light->GetSwitch() != 0 ? 1 : 0;
  }
  return on;
}

std::size_t countDifferent(const std::vector<unsigned char>& one, const std::vector<unsigned char>& other)
{
  if (one.size() != other.size())
  {
    return std::max(one.size(), other.size());
  }
  std::size_t different = 0;
  for (std::size_t i = 0; i < one.size(); ++i)
  {
    different += one[i] != other[i] ? 1 : 0;
  }
  return different;
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
  const std::vector<vtkRenderer*> renderers = renderersOf(window, pass);
  const bool hasMasks = !renderers.empty() && drawn.status <= vtkShadowVolumePass::STATUS_PARTIAL;
  const int lights = hasMasks ? countLights(renderers.back()) : 0;
  for (int light = 0; light < lights; ++light)
  {
    vtkNew<vtkImageData> image;
    pass->GetShadowMask(light, image);
    const auto* pixels = static_cast<const unsigned char*>(image->GetScalarPointer());
    drawn.masks.emplace_back(pixels, pixels + image->GetNumberOfPoints());
  }
  const int* size = window->GetSize();
  vtkNew<vtkUnsignedCharArray> pixels;
  window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, 0, pixels.GetPointer(), 0);
  drawn.picture.assign(pixels->GetPointer(0), pixels->GetPointer(0) + pixels->GetNumberOfValues());
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
