#include "DropInCase.h"

#include <algorithm>
#include <cstdlib>
#include <ostream>

#include <vtkActorCollection.h>
#include <vtkAssemblyNode.h>
#include <vtkAssemblyPath.h>
#include <vtkFloatArray.h>
#include <vtkHardwareSelector.h>
#include <vtkImageData.h>
#include <vtkLightCollection.h>
#include <vtkPropCollection.h>
#include <vtkProperty.h>
#include <vtkSilhouettePass.h>
#include <vtkUnsignedCharArray.h>

namespace shadow::test
{

namespace
{

int countSwitchedOn(vtkLightCollection* lights)
{
  int count = 0;
  for (int i = 0; i < lights->GetNumberOfItems(); ++i)
  {
    count += vtkLight::SafeDownCast(lights->GetItemAsObject(i))->GetSwitch() != 0 ? 1 : 0;
  }
  return count;
}

vtkSmartPointer<vtkRenderPass> makePass(Way way, const std::vector<vtkRenderer*>& renderers)
{
  const auto shadows = vtkSmartPointer<vtkShadowVolumePass>::New();
  shadows->SetShadowIntensity(way == NoCasters || way == Shadowed ? 1.0 : 0.0);
  shadows->SetCompositing(way == Additive ? vtkShadowVolumePass::COMPOSITING_ADDITIVE
                                          : vtkShadowVolumePass::COMPOSITING_MASK);
  for (vtkRenderer* renderer : renderers)
  {
    vtkPropCollection* props = renderer->GetViewProps();
    for (int i = 0; way == NoCasters && i < props->GetNumberOfItems(); ++i)
    {
      shadows->SetCasting(vtkProp::SafeDownCast(props->GetItemAsObject(i)), false);
    }
  }
  if (way != LinesOff && way != LinesOffOverMask)
  {
    return shadows;
  }
  const auto outlines = vtkSmartPointer<vtkSilhouettePass>::New();
  outlines->SilhouetteEdgesOff();
  outlines->BorderEdgesOff();
  outlines->CreaseEdgesOff();
  outlines->SetDelegatePass(way == LinesOffOverMask ? shadows : nullptr);
  return outlines;
}

/// @return our pass, if there is a way
vtkSmartPointer<vtkRenderPass> prepare(DropInScene& scene, const Row& row, const Way* way)
{
  row.build(scene);
  scene.renderer->ResetCameraClippingRange();
  vtkSmartPointer<vtkRenderPass> ours;
  if (way != nullptr)
  {
    ours = makePass(*way, scene.passed);
  }
  for (vtkRenderer* renderer : scene.passed)
  {
    if (row.attach)
    {
      row.attach(renderer, ours);
    }
    else
    {
      renderer->SetPass(ours);
    }
  }
  return ours;
}

Picture read(vtkRenderWindow* window)
{
  const int right = window->GetActualSize()[0] - 1; // of a tile, where there are tiles
  const int top = window->GetActualSize()[1] - 1;
  vtkNew<vtkUnsignedCharArray> colour;
  window->GetRGBACharPixelData(0, 0, right, top, 0, colour.GetPointer(), 0);
  vtkNew<vtkFloatArray> depth;
  window->GetZbufferData(0, 0, right, top, depth.GetPointer());
  return {{colour->GetPointer(0), colour->GetPointer(0) + colour->GetNumberOfValues()},
          {depth->GetPointer(0), depth->GetPointer(0) + depth->GetNumberOfValues()}};
}

std::vector<int> pickOnGrid(DropInScene& scene)
{
  std::vector<int> found;
  for (int x = 10; x < scene.window->GetSize()[0]; x += 20)
  {
    for (int y = 10; y < scene.window->GetSize()[1]; y += 20)
    {
      vtkAssemblyPath* path = scene.renderer->PickPropFrom(x, y, scene.pickFrom);
      vtkProp* prop = path != nullptr ? path->GetFirstNode()->GetViewProp() : nullptr;
      found.push_back(prop != nullptr ? scene.renderer->GetViewProps()->IsItemPresent(prop) : 0);
      found.push_back(0);
    }
  }
  return found;
}

} // namespace

std::ostream& operator<<(std::ostream& os, const Row& row)
{
  return os << row.name;
}

const char* toString(Way way)
{
  switch (way)
  {
  case Mask:
    return "mask";
  case Additive:
    return "additive";
  case NoCasters:
    return "no casters";
  case LinesOff:
    return "lines off";
  case LinesOffOverMask:
    return "lines off over mask";
  case Shadowed:
    return "shadowed";
  default:
    return "selection";
  }
}

Pictures draw(const Row& row, const Way* way, bool flat)
{
  DropInScene scene;
  prepare(scene, row, way);
  for (vtkRenderer* renderer : scene.passed)
  {
    vtkActorCollection* actors = renderer->GetActors();
    for (int i = 0; flat && i < actors->GetNumberOfItems(); ++i)
    {
      vtkActor::SafeDownCast(actors->GetItemAsObject(i))->GetProperty()->SetInterpolationToFlat();
    }
  }
  Pictures pictures;
  for (Picture& picture : pictures)
  {
    if (scene.render)
    {
      scene.render();
    }
    else
    {
      scene.window->Render();
    }
    picture = read(scene.window);
    picture.colour.insert(picture.colour.end(), scene.tiled.begin(), scene.tiled.end());
  }
  return pictures;
}

Picture drawShadowed(const Row& row, const Picture& plain)
{
  constexpr Way way = Shadowed;
  DropInScene scene;
  const auto pass = prepare(scene, row, &way);
  scene.window->Render();
  Picture picture = read(scene.window);
  int* size = scene.renderer->GetSize();
  const bool isOneView = !scene.render && scene.passed.size() == 1 && scene.window->GetStereoRender() == 0 &&
                         picture.depth.size() == static_cast<std::size_t>(size[0] * size[1]);
  if (!isOneView)
  {
    return plain;
  }
  const int lights = countSwitchedOn(scene.renderer->GetLights());
  for (int light = 0; light < lights; ++light)
  {
    vtkNew<vtkImageData> mask;
    if (!static_cast<vtkShadowVolumePass*>(pass.GetPointer())->GetShadowMask(light, mask) ||
        static_cast<std::size_t>(mask->GetNumberOfPoints()) != picture.depth.size())
    {
      return {};
    }
    const auto* reached = static_cast<const unsigned char*>(mask->GetScalarPointer());
    for (std::size_t i = 0; i < picture.colour.size(); ++i)
    {
      picture.colour[i] = reached[i / 4] < 255 ? plain.colour[i] : picture.colour[i];
    }
  }
  return picture;
}

Picture drawAfter(const Row& row, Way way)
{
  DropInScene scene;
  prepare(scene, row, &way);
  scene.window->Render();
  scene.renderer->SetPass(nullptr);
  scene.window->Render();
  return read(scene.window);
}

int countRoundings(const Row& row)
{
  DropInScene scene;
  prepare(scene, row, nullptr);
  // Halves are rounded to even: means that are 1 apart can be 2 apart then.
  const int ofSamples = scene.window->GetMultiSamples() > 0 ? 1 : 0;
  return std::max(countSwitchedOn(scene.renderer->GetLights()), 1) + ofSamples;
}

std::ostream& operator<<(std::ostream& os, const Difference& difference)
{
  return os << difference.colour << " px in colour, " << difference.alpha << " in alpha, by "
            << difference.largest << " at most, " << difference.depth << " in depth";
}

Difference compare(const Picture& a, const Picture& b, int tolerance)
{
  Difference difference;
  if (a.colour.size() != b.colour.size() || a.depth.size() != b.depth.size())
  {
    return {std::max(a.colour.size(), b.colour.size()) / 4, 0, std::max(a.depth.size(), b.depth.size()), 255};
  }
  for (std::size_t pixel = 0; pixel < a.colour.size(); pixel += 4)
  {
    std::array<int, 4> by{};
    for (std::size_t i = 0; i < 4; ++i)
    {
      by[i] = std::abs(a.colour[pixel + i] - b.colour[pixel + i]);
    }
    difference.colour += std::max({by[0], by[1], by[2]}) > tolerance ? 1 : 0;
    difference.alpha += by[3] != 0 ? 1 : 0;
    difference.largest = std::max({difference.largest, by[0], by[1], by[2], by[3]});
  }
  for (std::size_t pixel = 0; pixel < a.depth.size(); ++pixel)
  {
    difference.depth += a.depth[pixel] != b.depth[pixel] ? 1 : 0;
  }
  return difference;
}

std::vector<int> pick(const Row& row, const Way* way)
{
  DropInScene scene;
  prepare(scene, row, way);
  scene.window->Render();
  if (scene.pickFrom != nullptr)
  {
    return pickOnGrid(scene);
  }
  const auto width = static_cast<unsigned int>(scene.window->GetActualSize()[0]);
  const auto height = static_cast<unsigned int>(scene.window->GetActualSize()[1]);
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(scene.renderer);
  selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_CELLS);
  selector->SetArea(0, 0, width - 1, height - 1);
  std::vector<int> found;
  if (!selector->CaptureBuffers())
  {
    return found;
  }
  for (unsigned int y = 0; y < height; ++y)
  {
    for (unsigned int x = 0; x < width; ++x)
    {
      const std::array<unsigned int, 2> pixel{x, y};
      const vtkHardwareSelector::PixelInformation at = selector->GetPixelInformation(pixel.data());
      found.push_back(at.Valid ? at.PropID : -1);
      found.push_back(at.Valid ? static_cast<int>(at.AttributeID) : -1);
    }
  }
  return found;
}

} // namespace shadow::test
