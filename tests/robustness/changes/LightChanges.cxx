// What happens to lights.
#include "Changes.h"

namespace shadow::fuzz
{

namespace
{

void removeLight(ChangingScene& scene, FuzzRandom& random)
{
  if (scene.lights.size() > 1)
  {
    const std::size_t place = random.below(scene.lights.size());
    scene.renderer->RemoveLight(scene.lights[place]);
    scene.second->RemoveLight(scene.lights[place]);
    scene.lights.erase(scene.lights.begin() + static_cast<std::ptrdiff_t>(place));
  }
}

void moveLight(ChangingScene& scene, FuzzRandom& random)
{
  const glm::dvec3 to = 5.0 * random.direction();
  scene.pickLight(random)->SetPosition(to.x, glm::abs(to.y) + 0.5, to.z);
}

void changeType(ChangingScene& scene, FuzzRandom& random)
{
  vtkLight* light = scene.pickLight(random);
  switch (random.below(4))
  {
  case 0:
    light->SetLightTypeToHeadlight();
    break;
  case 1:
    light->SetLightTypeToCameraLight();
    break;
  default:
    light->SetLightTypeToSceneLight();
  }
}

} // namespace

std::vector<Change> listLightChanges()
{
  return {
      {"light added",
       [](ChangingScene& s, FuzzRandom& r)
       {
         if (s.lights.size() < 6)
         {
           s.addLight(r);
         }
       }},
      {"light removed", removeLight},
      {"light moved", moveLight},
      {"light moved", moveLight},
      {"light's aim",
       [](ChangingScene& s, FuzzRandom& r) { s.pickLight(r)->SetFocalPoint(r.real(), 0.0, r.real()); }},
      {"light's cone",
       [](ChangingScene& s, FuzzRandom& r) { s.pickLight(r)->SetConeAngle(r.between(10.0, 180.0)); }},
      {"light positional or not",
       [](ChangingScene& s, FuzzRandom& r) { s.pickLight(r)->SetPositional(r.chance(0.6)); }},
      {"light on or off", [](ChangingScene& s, FuzzRandom& r) { s.pickLight(r)->SetSwitch(r.chance(0.7)); }},
      {"light's type", changeType},
      {"light's shadow",
       [](ChangingScene& s, FuzzRandom& r) { s.pickLight(r)->SetShadowAttenuation(r.real()); }},
      {"light's colour",
       [](ChangingScene& s, FuzzRandom& r) { s.pickLight(r)->SetColor(1.0, r.real(), r.real()); }}};
}

} // namespace shadow::fuzz
