#include <vtkProperty.h>
#include <vtkTexture.h>

#include "DropInCase.h"

// Actors that are seen through.
namespace shadow::test
{

std::vector<Row> translucentRows()
{
  const auto three = [](DropInScene& scene, int order)
  {
    const std::array<double, 3> colours[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const std::array<double, 3> centres[] = {{-0.8, 0.6, 0.6}, {-0.4, 0.7, 1.1}, {0.0, 0.6, 0.9}};
    for (std::size_t i = 0; i < 3; ++i)
    {
      const std::size_t at = order > 0 ? i : 2 - i;
      addGlass(scene, colours[at], centres[at]);
    }
  };
  return {
      {"translucent",
       [](DropInScene& scene) {
         addGlass(scene, {1, 0, 0}, {0.5, 0.6, 1.0});
       }},
      {"translucent_three", [three](DropInScene& scene) { three(scene, 1); }},
      {"translucent_three_backwards", [three](DropInScene& scene) { three(scene, -1); }},
      {"translucent_intersecting",
       [](DropInScene& scene)
       {
         addGlass(scene, {1, 0, 0}, {0.6, 0.6, 1.0});
         addGlass(scene, {0, 1, 0}, {0.9, 0.7, 1.1});
         addBox(scene, 0.8, 1.0)->GetProperty()->SetOpacity(0.3);
       }},
      {"translucent_mesh_around_opaque",
       [](DropInScene& scene) {
         addGlass(scene, {0.2, 0.9, 0.9}, {0.0, 1.0, 0.0})->SetScale(2.0);
       }},
      {"translucent_only",
       [](DropInScene& scene)
       {
         scene.renderer->RemoveAllViewProps();
         addGlass(scene, {1, 0, 0}, {0.0, 0.6, 1.0});
         addGlass(scene, {0, 0, 1}, {0.3, 0.6, 0.6});
       }},
      {"translucent_table", [](DropInScene& scene) { scene.table->GetProperty()->SetOpacity(0.6); }},
      {"translucent_texture", [](DropInScene& scene) { scene.table->SetTexture(makeTexture(4)); }},
      {"translucent_forced", [](DropInScene& scene) { scene.ballActor->ForceTranslucentOn(); }},
      {"translucent_wireframe",
       [](DropInScene& scene) {
         addGlass(scene, {1, 0, 0}, {0.5, 0.6, 1.0})->GetProperty()->SetRepresentationToWireframe();
       }},
      {"translucent_edges",
       [](DropInScene& scene) {
         addGlass(scene, {1, 0, 0}, {0.5, 0.6, 1.0})->GetProperty()->EdgeVisibilityOn();
       }},
      {"translucent_backs_culled",
       [](DropInScene& scene) {
         addGlass(scene, {1, 0, 0}, {0.5, 0.6, 1.0})->GetProperty()->BackfaceCullingOn();
       }},
      {"translucent_physically_based",
       [](DropInScene& scene) {
         addGlass(scene, {1, 0, 0}, {0.5, 0.6, 1.0})->GetProperty()->SetInterpolationToPBR();
       }},
  };
}

} // namespace shadow::test
