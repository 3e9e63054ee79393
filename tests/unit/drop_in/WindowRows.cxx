#include <utility>

#include <vtkCamera.h>
#include <vtkImageData.h>
#include <vtkProperty.h>
#include <vtkTexture.h>
#include <vtkWindowToImageFilter.h>

#include "DropInCase.h"

// What windows can be set to, and renderers beside and above each other.
namespace shadow::test
{

namespace
{

Row stereo(const char* name, int kind)
{
  return {name, [kind](DropInScene& scene)
          {
            addBox(scene, 1.0, 0.6);
            scene.window->SetStereoType(kind);
            scene.window->StereoRenderOn();
          }};
}

/// A second renderer, with a box and a lamp of its own.
vtkRenderer* addRenderer(DropInScene& scene)
{
  vtkNew<vtkRenderer> second;
  second->SetActiveCamera(scene.renderer->GetActiveCamera());
  second->SetBackground(0.1, 0.3, 0.2);
  second->AddActor(addBox(scene, 0.6, 1.0));
  scene.renderer->RemoveActor(scene.renderer->GetActors()->GetLastActor());
  second->AddLight(scene.lamp);
  scene.window->AddRenderer(second);
  scene.passed.push_back(second);
  scene.kept.emplace_back(second);
  return second;
}

/// A row with a renderer in a second layer.
template <class Set>
Row layers(const char* name, Set set)
{
  return {name, [set](DropInScene& scene)
          {
            scene.window->SetNumberOfLayers(2);
            vtkRenderer* above = addRenderer(scene);
            above->SetLayer(1);
            set(scene, above);
          }};
}

void divide(DropInScene& scene)
{
  vtkRenderer* second = addRenderer(scene);
  scene.renderer->SetViewport(0.0, 0.0, 0.5, 1.0);
  second->SetViewport(0.55, 0.1, 0.95, 0.8);
}

/// Tiles, put together as vtkWindowToImageFilter does it.
void tile(DropInScene& scene)
{
  scene.render = [&scene]
  {
    vtkNew<vtkWindowToImageFilter> filter;
    filter->SetInput(scene.window);
    filter->SetScale(2);
    filter->ReadFrontBufferOff();
    filter->SetInputBufferTypeToRGBA();
    filter->Update();
    vtkImageData* image = filter->GetOutput();
    const auto* values = static_cast<const unsigned char*>(image->GetScalarPointer());
    scene.tiled.assign(values, values + 4 * image->GetNumberOfPoints());
  };
}

void showTile(DropInScene& scene)
{
  scene.window->SetTileScale(2, 2);
  scene.window->SetTileViewport(0.5, 0.0, 1.0, 0.5);
}

vtkSmartPointer<vtkTexture> makeSRGBTexture()
{
  const vtkSmartPointer<vtkTexture> texture = makeTexture();
  texture->UseSRGBColorSpaceOn();
  return texture;
}

} // namespace

std::vector<Row> windowRows()
{
  using S = DropInScene&;
  using R = vtkRenderer*;
  return {
      stereo("stereo_red_blue", VTK_STEREO_RED_BLUE),
      {"stereo_anaglyph", stereo("", VTK_STEREO_ANAGLYPH).build, nullptr, wholeWays},
      stereo("stereo_interlaced", VTK_STEREO_INTERLACED),
      stereo("stereo_left", VTK_STEREO_LEFT),
      stereo("stereo_right", VTK_STEREO_RIGHT),
      stereo("stereo_dresden", VTK_STEREO_DRESDEN),
      stereo("stereo_checkerboard", VTK_STEREO_CHECKERBOARD),
      stereo("stereo_side_by_side", VTK_STEREO_SPLITVIEWPORT_HORIZONTAL),
      {"stereo_anaglyph_parallel",
       [](S scene)
       {
         stereo("", VTK_STEREO_ANAGLYPH).build(scene);
         scene.renderer->GetActiveCamera()->ParallelProjectionOn();
         scene.renderer->GetActiveCamera()->SetParallelScale(2.0);
       },
       nullptr, wholeWays},
      {"stereo_anaglyph_of_glass",
       [](S scene)
       {
         stereo("", VTK_STEREO_ANAGLYPH).build(scene);
         addGlass(scene, {0, 1, 0}, {-0.4, 0.6, 1.0});
       },
       nullptr, wholeWays},
      layers("layers", [](S, R) {}),
      layers("layers_depth_preserved", [](S, R above) { above->PreserveDepthBufferOn(); }),
      layers("layers_colour_preserved", [](S, R above) { above->PreserveColorBufferOn(); }),
      layers("layers_colour_not_preserved", [](S, R above) { above->PreserveColorBufferOff(); }),
      layers("layers_glass_above",
             [](S scene, R above) {
               above->AddActor(addGlass(scene, {1, 0, 0}, {-0.5, 0.6, 1.0}));
             }),
      layers("layers_pass_below", [](S scene, R) { scene.passed.pop_back(); }),
      layers("layers_pass_above", [](S scene, R) { scene.passed.erase(scene.passed.begin()); }),
      {"viewports", divide},
      {"viewports_small_window", [](S scene) { divide(scene), scene.window->SetSize(61, 43); }},
      {"viewport_in_the_middle", [](S scene) { scene.renderer->SetViewport(0.23, 0.31, 0.81, 0.77); }},
      {"renderer_not_drawn", [](S scene) { divide(scene), scene.renderer->DrawOff(); }},
      {"gradient",
       [](S scene)
       {
         scene.renderer->GradientBackgroundOn();
         scene.renderer->SetBackground2(0.9, 0.5, 0.1);
       }},
      {"textured_background",
       [](S scene)
       {
         scene.renderer->SetBackgroundTexture(makeTexture());
         scene.renderer->TexturedBackgroundOn();
       },
       nullptr, everyWay & ~Selecting}, // VTK takes the texture's colours for props, not always the same
      {"transparent_background", [](S scene) { scene.renderer->SetBackgroundAlpha(0.0); }},
      {"half_transparent_background_and_glass",
       [](S scene)
       {
         scene.renderer->SetBackgroundAlpha(0.4);
         scene.window->SetAlphaBitPlanes(1);
         addGlass(scene, {1, 0, 0}, {-0.5, 0.6, 1.0});
         scene.table->VisibilityOff();
       }},
      {"alpha_planes", [](S scene) { scene.window->SetAlphaBitPlanes(1); }},
      {"multisampled", [](S scene) { scene.window->SetMultiSamples(8), addBox(scene, 1.0, 0.6); }},
      {"multisampled_wires",
       [](S scene)
       {
         scene.window->SetMultiSamples(8);
         addBox(scene, 1.0, 0.6)->GetProperty()->SetRepresentationToWireframe();
       }},
      {"multisampled_glass",
       [](S scene) {
         scene.window->SetMultiSamples(8), addGlass(scene, {1, 0, 0}, {-0.5, 0.6, 1.0});
       }},
      {"smoothed_lines",
       [](S scene)
       {
         scene.window->LineSmoothingOn();
         scene.window->PointSmoothingOn();
         scene.window->PolygonSmoothingOn();
         addBox(scene, 1.0, 0.6)->GetProperty()->SetRepresentationToWireframe();
       }},
      {"srgb_window", [](S scene) { scene.window->SetUseSRGBColorSpace(true); }},
      {"srgb_texture", [](S scene) { scene.table->SetTexture(makeSRGBTexture()); }},
      {"stencil_capable", [](S scene) { scene.window->StencilCapableOn(); }},
      {"tiles", tile},
      {"one_tile", showTile},
      {"tiles_of_glass",
       [](S scene) {
         tile(scene), addGlass(scene, {1, 0, 0}, {-0.5, 0.6, 1.0});
       }},
      {"odd_size", [](S scene) { scene.window->SetSize(101, 67); }},
      {"resized_in_between",
       [](S scene)
       {
         scene.render = [&scene]
         {
           scene.window->Render();
           scene.window->SetSize(scene.window->GetSize()[0] - 20, 90);
           scene.window->Render();
         };
       }},
  };
}

} // namespace shadow::test
