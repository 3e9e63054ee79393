#pragma once

#include <functional>
#include <vector>

#include "TruthScene.h"

class vtkCamera;
class vtkLight;
class vtkProp;
class vtkRenderer;

namespace shadow::truth
{

/// Whether a prop casts a shadow. Asked for every prop from the renderer's down to the leaf of an assembly; a
/// leaf casts when all of them do.
using CastsShadow = std::function<bool(vtkProp*)>;

/// The triangles that a renderer draws as opaque surfaces, from VTK's props alone: visible props, assemblies
/// with their matrices, face culling, clipping planes. Updates the mappers' pipelines; needs no graphics
/// context.
///
/// @throws std::invalid_argument  for a visible opaque surface whose mapper appendWorldTriangles() does not
/// cover
Scene sceneFromRenderer(vtkRenderer* renderer, const CastsShadow& casts = {});

/// @param width, height  of the viewport in pixels; their ratio is the camera's aspect
View viewFromCamera(vtkCamera* camera, int width, int height);

/// The view of the renderer's active camera in its viewport. @pre the renderer is in a window
View viewFromRenderer(vtkRenderer* renderer);

struct RendererLight
{
  Light light;
  bool casts = true; ///< false for a headlight, whose shadows the camera cannot see
  vtkLight* source = nullptr;
};

/// The lights that are switched on, in the renderer's order. Lights that follow the camera are taken where
/// the last vtkRenderer::UpdateLightsGeometryToFollowCamera() (each rendering calls it) left them.
std::vector<RendererLight> lightsFromRenderer(vtkRenderer* renderer);

} // namespace shadow::truth
