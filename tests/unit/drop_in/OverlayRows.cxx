#include <vtkActor2D.h>
#include <vtkAxesActor.h>
#include <vtkBillboardTextActor3D.h>
#include <vtkBoxRepresentation.h>
#include <vtkChartXY.h>
#include <vtkContextActor.h>
#include <vtkContextScene.h>
#include <vtkCornerAnnotation.h>
#include <vtkCubeAxesActor.h>
#include <vtkDiskSource.h>
#include <vtkFloatArray.h>
#include <vtkGenericRenderWindowInteractor.h>
#include <vtkLabeledDataMapper.h>
#include <vtkLineSource.h>
#include <vtkLookupTable.h>
#include <vtkOrientationMarkerWidget.h>
#include <vtkPlot.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>
#include <vtkScalarBarActor.h>
#include <vtkTable.h>
#include <vtkTextActor.h>
#include <vtkTextActor3D.h>
#include <vtkTextProperty.h>
#include <vtkTransform.h>
#include <vtkXYPlotActor.h>

#include "DropInCase.h"

// Props that lie over the scene, or are drawn into it as text.
namespace shadow::test
{

namespace
{

vtkSmartPointer<vtkActor2D> makeDisk(double opacity)
{
  vtkNew<vtkDiskSource> disk;
  disk->SetInnerRadius(10.0);
  disk->SetOuterRadius(30.0);
  disk->SetCircumferentialResolution(20);
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputConnection(disk->GetOutputPort());
  const auto actor = vtkSmartPointer<vtkActor2D>::New();
  actor->SetMapper(mapper);
  actor->SetPosition(30.0, 75.0);
  actor->GetProperty()->SetColor(1.0, 0.8, 0.0);
  actor->GetProperty()->SetOpacity(opacity);
  return actor;
}

void addText(DropInScene& scene)
{
  vtkNew<vtkTextActor> text;
  text->SetInput("drop-in");
  text->SetPosition(10, 10);
  text->GetTextProperty()->SetFontSize(24);
  scene.renderer->AddViewProp(text);
}

void addScalarBar(DropInScene& scene)
{
  vtkNew<vtkScalarBarActor> bar;
  vtkNew<vtkLookupTable> table;
  table->Build();
  bar->SetLookupTable(table);
  bar->SetTitle("height");
  scene.renderer->AddViewProp(bar);
}

void addCubeAxes(DropInScene& scene)
{
  vtkNew<vtkCubeAxesActor> axes;
  axes->SetBounds(-1.5, 1.5, 0.0, 1.6, -1.0, 1.0);
  axes->SetCamera(scene.renderer->GetActiveCamera());
  axes->DrawXGridlinesOn();
  axes->DrawYGridlinesOn();
  scene.renderer->AddActor(axes);
}

void addAxes(DropInScene& scene)
{
  vtkNew<vtkAxesActor> axes;
  vtkNew<vtkTransform> there;
  there->Translate(0.8, 0.2, 0.8);
  axes->SetUserTransform(there);
  scene.renderer->AddActor(axes);
}

template <class Text>
void addTextInScene(DropInScene& scene)
{
  vtkNew<Text> text;
  text->SetInput("drop-in");
  text->GetTextProperty()->SetFontSize(30);
  text->SetPosition(-0.5, 0.3, 1.0);
  if constexpr (std::is_same_v<Text, vtkTextActor3D>)
  {
    text->SetScale(0.015);
  }
  scene.renderer->AddActor(text);
}

void addLabels(DropInScene& scene)
{
  scene.ball->SetThetaResolution(4);
  scene.ball->SetPhiResolution(4);
  vtkNew<vtkLabeledDataMapper> mapper;
  mapper->SetInputConnection(scene.ball->GetOutputPort());
  vtkNew<vtkActor2D> labels;
  labels->SetMapper(mapper);
  scene.renderer->AddViewProp(labels);
}

vtkSmartPointer<vtkTable> makeCurve()
{
  vtkNew<vtkFloatArray> x;
  vtkNew<vtkFloatArray> y;
  x->SetName("x");
  y->SetName("y");
  for (int i = 0; i < 10; ++i)
  {
    x->InsertNextValue(static_cast<float>(i));
    y->InsertNextValue(static_cast<float>(i * (9 - i)));
  }
  const auto table = vtkSmartPointer<vtkTable>::New();
  table->AddColumn(x);
  table->AddColumn(y);
  return table;
}

void addPlot(DropInScene& scene)
{
  vtkNew<vtkLineSource> line;
  line->SetResolution(8);
  line->Update();
  vtkNew<vtkXYPlotActor> plot;
  vtkNew<vtkPolyData> sampled;
  sampled->DeepCopy(line->GetOutput());
  vtkNew<vtkFloatArray> values;
  for (int i = 0; i < 9; ++i)
  {
    values->InsertNextValue(static_cast<float>(i * i));
  }
  sampled->GetPointData()->SetScalars(values);
  plot->AddDataSetInput(sampled);
  plot->SetPosition(0.1, 0.1);
  plot->SetPosition2(0.7, 0.7);
  scene.renderer->AddViewProp(plot);
}

void addChart(DropInScene& scene)
{
  vtkNew<vtkChartXY> chart;
  chart->SetAutoSize(false);
  chart->SetSize(vtkRectf(10.0f, 10.0f, 100.0f, 80.0f));
  chart->AddPlot(vtkChart::LINE)->SetInputData(makeCurve(), 0, 1);
  vtkNew<vtkContextActor> actor;
  actor->GetScene()->AddItem(chart);
  scene.renderer->AddViewProp(actor);
  actor->GetScene()->SetRenderer(scene.renderer);
}

void addCorner(DropInScene& scene)
{
  vtkNew<vtkCornerAnnotation> corner;
  corner->SetText(0, "lower left");
  corner->SetText(3, "upper right");
  scene.renderer->AddViewProp(corner);
}

void addMarker(DropInScene& scene)
{
  vtkNew<vtkGenericRenderWindowInteractor> interactor;
  interactor->SetRenderWindow(scene.window);
  vtkNew<vtkAxesActor> axes;
  vtkNew<vtkOrientationMarkerWidget> widget;
  widget->SetOrientationMarker(axes);
  widget->SetDefaultRenderer(scene.renderer);
  widget->SetInteractor(interactor);
  widget->SetViewport(0.0, 0.0, 0.4, 0.4);
  widget->SetEnabled(1);
  scene.kept = {interactor, widget};
}

void addHandles(DropInScene& scene)
{
  vtkNew<vtkBoxRepresentation> handles;
  double bounds[6] = {0.6, 1.4, 0.1, 0.9, 0.2, 1.0};
  handles->SetPlaceFactor(1.0);
  handles->PlaceWidget(bounds);
  handles->SetRenderer(scene.renderer);
  handles->HandlesOn();
  scene.renderer->AddViewProp(handles);
}

} // namespace

std::vector<Row> overlayRows()
{
  return {
      {"actor_2d", [](DropInScene& scene) { scene.renderer->AddViewProp(makeDisk(1.0)); }},
      {"actor_2d_translucent", [](DropInScene& scene) { scene.renderer->AddViewProp(makeDisk(0.5)); }},
      {"text", addText},
      {"scalar_bar", addScalarBar},
      {"cube_axes", addCubeAxes},
      {"axes", addAxes},
      {"billboard_text", addTextInScene<vtkBillboardTextActor3D>},
      {"text_3d", addTextInScene<vtkTextActor3D>},
      {"labels", addLabels},
      {"corner_annotation", addCorner},
      {"xy_plot", addPlot},
      {"chart", addChart},
      {"orientation_marker", addMarker},
      {"box_with_handles", addHandles},
  };
}

} // namespace shadow::test
