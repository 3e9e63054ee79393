#include <vtkCamera.h>
#include <vtkLight.h>
#include <vtkLightKit.h>
#include <vtkMatrix4x4.h>
#include <vtkOpenGLGPUVolumeRayCastMapper.h>
#include <vtkPropCollection.h>
#include <vtkProperty.h>
#include <vtkTexture.h>

#include "DropInCase.h"

// What renderers, cameras and lights can be set to.
namespace shadow::test
{

namespace
{

void addGlasses(DropInScene& scene)
{
  addGlass(scene, {1, 0, 0}, {-0.5, 0.6, 1.0});
  addGlass(scene, {0, 1, 0}, {0.0, 0.7, 1.2});
  addGlass(scene, {0, 0, 1}, {0.3, 0.6, 0.8});
}

void addWires(DropInScene& scene)
{
  addBox(scene, 1.0, 0.6, 0.8)->GetProperty()->SetRepresentationToWireframe();
  addBox(scene, -1.0, 0.6, 0.8)->GetProperty()->SetRepresentationToWireframe();
}

void peel(DropInScene& scene)
{
  scene.window->SetMultiSamples(0);
  scene.window->SetAlphaBitPlanes(1);
  scene.renderer->UseDepthPeelingOn();
  scene.renderer->SetMaximumNumberOfPeels(20);
  scene.renderer->SetOcclusionRatio(0.0);
  addGlasses(scene);
}

void occlude(DropInScene& scene, double radius, bool blur = false)
{
  scene.renderer->UseSSAOOn();
  scene.renderer->SetSSAORadius(radius);
  scene.renderer->SetSSAOBias(0.01);
  scene.renderer->SetSSAOBlur(blur);
  addBox(scene, 1.0, 0.6);
}

/// Draws a second picture over the first, from elsewhere.
void drawOver(DropInScene& scene, const std::function<void()>& eraseOff)
{
  scene.render = [&scene, eraseOff]
  {
    scene.window->Render();
    eraseOff();
    scene.renderer->GetActiveCamera()->Azimuth(20.0);
  };
}

/// A row that sets something of the camera.
template <class Set>
Row camera(const char* name, Set set)
{
  return {name, [set](DropInScene& scene)
          {
            addBox(scene, 1.0, 0.6);
            set(scene.renderer->GetActiveCamera());
          }};
}

/// In a sheared view VTK turns normals towards the camera's position, which is not where the view is from;
/// the mask knows better.
Row shearedView()
{
  Row row = camera("view_sheared", [](vtkCamera* of) { of->SetViewShear(0.3, 0.1, 1.0); });
  row.ways = everyWay & ~NoCasters;
  return row;
}

/// A row with other lights than the lamp.
template <class Light>
Row lights(const char* name, Light light)
{
  return {name, [light](DropInScene& scene)
          {
            addBox(scene, 1.0, 0.6);
            scene.renderer->RemoveAllLights();
            light(scene);
          }};
}

void addLight(DropInScene& scene, int type)
{
  vtkNew<vtkLight> light;
  light->SetLightType(type);
  light->SetPosition(0.5, 0.5, 1.0);
  scene.renderer->AddLight(light);
}

void addSpots(DropInScene& scene)
{
  const std::array<double, 3> colours[] = {{1.0, 0.2, 0.2}, {0.2, 1.0, 0.2}, {0.3, 0.3, 1.0}};
  for (int i = 0; i < 3; ++i)
  {
    vtkLight* spot = scene.addPointLight(-2.0 + 2.0 * i, 4.0, 1.0);
    spot->SetFocalPoint(-0.5 + 0.5 * i, 0.0, 0.0);
    spot->SetConeAngle(10.0 + 8.0 * i);
    spot->SetExponent(i);
    spot->SetAttenuationValues(1.0, 0.05 * i, 0.01);
    spot->SetDiffuseColor(colours[i][0], colours[i][1], colours[i][2]);
  }
}

void addKit(DropInScene& scene)
{
  vtkNew<vtkLightKit> kit;
  kit->AddLightsToRenderer(scene.renderer);
  scene.kept = {kit};
}

void lightByImage(DropInScene& scene)
{
  const vtkSmartPointer<vtkTexture> sky = makeTexture();
  sky->MipmapOn();
  scene.renderer->SetEnvironmentTexture(sky);
  scene.renderer->UseImageBasedLightingOn();
  vtkProperty* property = scene.ballActor->GetProperty();
  property->SetInterpolationToPBR();
  property->SetMetallic(0.8);
  property->SetRoughness(0.2);
}

} // namespace

std::vector<Row> settingRows()
{
  using R = DropInScene&;
  using C = vtkCamera*;
  return {
      {"depth_peeling", peel},
      {"depth_peeling_one_peel", [](R scene) { peel(scene), scene.renderer->SetMaximumNumberOfPeels(1); }},
      {"depth_peeling_of_volumes",
       [](R scene)
       {
         peel(scene);
         scene.renderer->UseDepthPeelingForVolumesOn();
         addVolume(scene, vtkNew<vtkOpenGLGPUVolumeRayCastMapper>(), false);
       }},
      {"depth_peeling_without_glass",
       [](R scene)
       {
         scene.renderer->UseDepthPeelingOn();
         scene.renderer->UseDepthPeelingForVolumesOn();
         addVolume(scene, vtkNew<vtkOpenGLGPUVolumeRayCastMapper>(), false);
       }},
      {"fxaa", [](R scene) { scene.renderer->UseFXAAOn(), addWires(scene); }, nullptr, filteredWays},
      {"fxaa_and_glass", [](R scene) { scene.renderer->UseFXAAOn(), addGlasses(scene); }, nullptr,
       filteredWays},
      {"ssao_narrow", [](R scene) { occlude(scene, 0.2); }},
      {"ssao_wide", [](R scene) { occlude(scene, 1.5); }},
      {"ssao_blurred", [](R scene) { occlude(scene, 0.5, true); }},
      {"ssao_and_glass", [](R scene) { occlude(scene, 0.5), addGlasses(scene); }, nullptr,
       everyWay & ~Shadowed},
      {"hidden_lines_removed", [](R scene) { scene.renderer->UseHiddenLineRemovalOn(), addWires(scene); }},
      {"hidden_lines_removed_without_wires", [](R scene) { scene.renderer->UseHiddenLineRemovalOn(); }},
      {"ssao_and_hidden_lines_removed",
       [](R scene) { occlude(scene, 0.5), scene.renderer->UseHiddenLineRemovalOn(), addWires(scene); }},
      {"two_sided_lighting_off",
       [](R scene)
       {
         scene.renderer->TwoSidedLightingOff();
         scene.ball->SetEndTheta(200.0);
         scene.ballActor->RotateY(180.0);
       }},
      {"erase_off", [](R scene) { drawOver(scene, [&scene] { scene.renderer->EraseOff(); }); }},
      {"window_erase_off", [](R scene) { drawOver(scene, [&scene] { scene.window->EraseOff(); }); }},
      {"picked_from_the_table_alone",
       [](R scene)
       {
         scene.pickFrom = vtkSmartPointer<vtkPropCollection>::New();
         scene.pickFrom->AddItem(scene.table);
         scene.ballActor->SetScale(1.5);
       }},
      {"image_based_lighting", lightByImage},
      {"image_based_lighting_of_glass",
       [](R scene)
       {
         lightByImage(scene);
         addGlass(scene, {0.9, 0.9, 0.9}, {-0.4, 0.6, 1.0})->GetProperty()->SetInterpolationToPBR();
       }},
      lights("lights_automatic", [](R scene) { scene.renderer->AutomaticLightCreationOn(); }),
      lights("lights_none", [](R) {}),
      lights("lights_off", [](R scene) { scene.addPointLight(0.0, 3.0, 0.0)->SwitchOff(); }),
      lights("headlight", [](R scene) { addLight(scene, VTK_LIGHT_TYPE_HEADLIGHT); }),
      lights("camera_light", [](R scene) { addLight(scene, VTK_LIGHT_TYPE_CAMERA_LIGHT); }),
      lights("light_kit", addKit),
      lights("directional", [](R scene) { scene.addDirectionalLight(0.5, -1.0, -0.3); }),
      lights("spots", addSpots),
      lights("spots_and_headlight",
             [](R scene) { addSpots(scene), addLight(scene, VTK_LIGHT_TYPE_HEADLIGHT); }),
      lights("directional_with_physically_based",
             [](R scene)
             {
               scene.addDirectionalLight(0.5, -1.0, -0.3);
               scene.addDirectionalLight(-0.5, -1.0, -0.3);
               scene.ballActor->GetProperty()->SetInterpolationToPBR();
             }),
      lights("lights_beyond_the_mask",
             [](R scene)
             {
               for (int i = 0; i < 34; ++i)
               {
                 scene.addDirectionalLight(0.05 * i - 0.8, -1.0, -0.3)->SetIntensity(0.02);
               }
             }),
      {"light_follows_camera_off", [](R scene) { scene.renderer->LightFollowCameraOff(); }},
      {"ambient_of_the_renderer", [](R scene) { scene.renderer->SetAmbient(0.9, 0.5, 0.1); }},
      camera("parallel", [](C of) { of->ParallelProjectionOn(), of->SetParallelScale(2.0); }),
      camera("narrow_view", [](C of) { of->SetViewAngle(8.0); }),
      camera("horizontal_view_angle", [](C of) { of->UseHorizontalViewAngleOn(); }),
      camera("off_centre", [](C of) { of->SetWindowCenter(0.3, -0.2); }),
      camera("off_axis",
             [](C of)
             {
               of->UseOffAxisProjectionOn();
               of->SetScreenBottomLeft(-1.0, -0.8, -1.5);
               of->SetScreenBottomRight(1.0, -0.8, -1.5);
               of->SetScreenTopRight(1.0, 0.8, -1.5);
             }),
      shearedView(),
      camera("rolled", [](C of) { of->Roll(30.0); }),
      camera("scissored",
             [](C of)
             {
               of->SetScissorRect(vtkRecti(30, 20, 70, 60));
               of->SetUseScissor(true);
             }),
      camera("view_transformed",
             [](C of)
             {
               vtkNew<vtkMatrix4x4> model;
               model->SetElement(0, 0, 1.5);
               of->SetModelTransformMatrix(model);
             }),
  };
}

} // namespace shadow::test
