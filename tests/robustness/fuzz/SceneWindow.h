#pragma once

#include <string>
#include <vector>

#include "FuzzScene.h"
#include "ShadowScene.h"
#include "TruthScene.h"

namespace shadow::fuzz
{

/// What one way to draw a scene gave.
struct DrawnMask
{
  FuzzConfig config;
  std::vector<unsigned char> mask; ///< lowest row first, 255 reached
  std::string refusal; ///< why the pass did not draw all, unless a mesh has no area; empty: it did
  std::size_t wrongInPicture = 0; ///< pixels in which the two compositings differ, see SceneWindow::draw()
};

/// A window that draws one scene after the other. GL objects that do not depend on the scene, such as
/// shaders, stay.
class SceneWindow
{
public:
  SceneWindow() : window(160, 120) {}

  /// Takes the place of the scene before.
  void show(const FuzzScene& scene);

  /// Draws the scene shown. Where the config adds up lights, its picture is held against the one that is made
  /// with the mask.
  DrawnMask draw(const FuzzConfig& config);

  /// What the ray caster needs of the scene shown, taken from the renderer. @pre it has been drawn
  truth::Scene getTruthScene();
  truth::View getView();
  truth::Light getLight();

private:
  void use(const FuzzConfig& config);
  std::size_t comparePictures(const FuzzConfig& config);

  truth::ShadowScene window;
  bool hasEmptyMesh = false; ///< without area, which the pass has to refuse
};

} // namespace shadow::fuzz
