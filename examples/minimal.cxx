// The least it takes to give an ordinary VTK scene exact shadows. Writes minimal.png, without a display.

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCubeSource.h>
#include <vtkHeadlessRenderWindow.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderer.h>
#include <vtkShadowVolumePass.h>
#include <vtkSphereSource.h>
#include <vtkWindowToImageFilter.h>

namespace
{

void add(vtkRenderer* renderer, vtkPolyDataAlgorithm* source, double y)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->SetPosition(0.0, y, 0.0);
  renderer->AddActor(actor);
}

} // namespace

int main()
{
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkSphereSource> ball;
  add(renderer, ball, 1.0);
  vtkNew<vtkCubeSource> table;
  table->SetXLength(4.0);
  table->SetZLength(4.0);
  add(renderer, table, -0.5);

  vtkNew<vtkLight> lamp;
  lamp->SetPositional(true);
  lamp->SetConeAngle(180.0);
  lamp->SetPosition(-3.0, 5.0, 2.0);
  renderer->AddLight(lamp);

  vtkNew<vtkShadowVolumePass> shadows;
  renderer->SetPass(shadows); // this line gives the scene its shadows

  vtkNew<vtkHeadlessRenderWindow> window;
  window->SetSize(640, 480);
  window->AddRenderer(renderer);
  renderer->GetActiveCamera()->SetPosition(2.0, 3.0, 6.0);
  renderer->ResetCamera();
  window->Render();

  vtkNew<vtkWindowToImageFilter> picture;
  picture->SetInput(window);
  picture->ReadFrontBufferOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(picture->GetOutputPort());
  writer->SetFileName("minimal.png");
  writer->Write();
  return shadows->GetStatus() == vtkShadowVolumePass::STATUS_OK ? 0 : 1;
}
