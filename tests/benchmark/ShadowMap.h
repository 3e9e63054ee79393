#pragma once

#include <vtkCameraPass.h>
#include <vtkNew.h>
#include <vtkRenderPassCollection.h>
#include <vtkSequencePass.h>
#include <vtkShadowMapBakerPass.h>
#include <vtkShadowMapPass.h>

/// VTK's own shadows at 2048 x 2048, for comparison, as the delegate of a camera pass.
inline void useShadowMap(vtkCameraPass* cameraPass)
{
  vtkNew<vtkShadowMapBakerPass> baker;
  baker->SetResolution(2048);
  vtkNew<vtkShadowMapPass> map;
  map->SetShadowMapBakerPass(baker);
  vtkNew<vtkRenderPassCollection> passes;
  passes->AddItem(baker);
  passes->AddItem(map);
  vtkNew<vtkSequencePass> sequence;
  sequence->SetPasses(passes);
  cameraPass->SetDelegatePass(sequence);
}
