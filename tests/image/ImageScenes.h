#pragma once

#include <map>
#include <string>

#include "ShadowScene.h"

namespace shadow::test
{

/// Fills a scene in a window of 320 x 240.
using MakeScene = void (*)(truth::ShadowScene& scene);

/// What each image test shows, by name.
const std::map<std::string, MakeScene>& imageScenes();

/// A ring, a block and a cone on a floor, in colours, and a camera in front of them.
struct StillLife
{
  explicit StillLife(truth::ShadowScene& scene);
  vtkActor* ring;
  vtkActor* block;
  vtkActor* cone;
  vtkActor* floor;
};

/// @name The scenes: light and camera
/// @{
void makePointLight(truth::ShadowScene& scene);
void makeDirectionalLight(truth::ShadowScene& scene);
void makeSpotLight(truth::ShadowScene& scene);
void makeTwoLights(truth::ShadowScene& scene);
void makeCameraInsideVolume(truth::ShadowScene& scene);
void makeParallelProjection(truth::ShadowScene& scene);
/// @}

/// @name The scenes: material and composition
/// @{
void makeAdditive(truth::ShadowScene& scene);
void makePhysicallyBased(truth::ShadowScene& scene);
void makeSmoothTexturedAndScalars(truth::ShadowScene& scene);
void makeTranslucentAndOverlay(truth::ShadowScene& scene);
void makeTwoViewports(truth::ShadowScene& scene);
void makeSamples(truth::ShadowScene& scene);
void makeOutlinesOverShadows(truth::ShadowScene& scene);
/// @}

} // namespace shadow::test
