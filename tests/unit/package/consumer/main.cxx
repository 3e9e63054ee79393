// Renders a ball over a table in a headless window; succeeds when the light's mask has both light and shadow.

#include <algorithm>
#include <iostream>

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkHeadlessRenderWindow.h>
#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkPlaneSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderer.h>
#include <vtkShadowVolumePass.h>
#include <vtkSphereSource.h>

namespace
{

void add(vtkRenderer* renderer, vtkPolyDataAlgorithm* source)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  renderer->AddActor(actor);
}

} // namespace

int main()
{
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkSphereSource> ball;
  ball->SetCenter(0.0, 0.0, 1.0);
  add(renderer, ball);
  vtkNew<vtkPlaneSource> table;
  table->SetOrigin(-2.0, -2.0, 0.0);
  table->SetPoint1(2.0, -2.0, 0.0);
  table->SetPoint2(-2.0, 2.0, 0.0);
  add(renderer, table);

  vtkNew<vtkLight> lamp;
  lamp->SetPositional(true);
  lamp->SetConeAngle(180.0);
  lamp->SetPosition(1.0, 1.0, 4.0);
  renderer->AddLight(lamp);
  vtkNew<vtkShadowVolumePass> shadows;
  renderer->SetPass(shadows);

  vtkNew<vtkHeadlessRenderWindow> window;
  window->SetSize(160, 120);
  window->AddRenderer(renderer);
  renderer->GetActiveCamera()->SetPosition(0.0, -6.0, 4.0);
  renderer->GetActiveCamera()->SetViewUp(0.0, 0.0, 1.0);
  renderer->ResetCamera();
  window->Render();

  vtkNew<vtkImageData> mask;
  if (!shadows->GetShadowMask(0, mask))
  {
    std::cerr << "no shadow mask: " << shadows->GetStatusMessage() << "\n";
    return 1;
  }
  const auto* pixels = static_cast<const unsigned char*>(mask->GetScalarPointer());
  const auto dark = std::count(pixels, pixels + mask->GetNumberOfPoints(), 0);
  std::cout << dark << " of " << mask->GetNumberOfPoints() << " pixels are in shadow\n";
  return dark > 100 && dark < mask->GetNumberOfPoints() / 2 ? 0 : 1;
}
