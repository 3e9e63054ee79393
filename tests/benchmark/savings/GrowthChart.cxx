// plotGrowth(), where VTK has charts.
#include <array>
#include <fstream>
#include <stdexcept>

#include <vtkAxis.h>
#include <vtkChartLegend.h>
#include <vtkChartXY.h>
#include <vtkContextActor.h>
#include <vtkContextScene.h>
#include <vtkFloatArray.h>
#include <vtkHeadlessRenderWindow.h>
#include <vtkNew.h>
#include <vtkPlot.h>
#include <vtkRenderer.h>
#include <vtkSVGExporter.h>
#include <vtkTable.h>

#include "CostGrowth.h"

namespace shadow::benchmarks
{

namespace
{

vtkSmartPointer<vtkTable> makeTable(const std::vector<std::pair<double, double>>& points, const std::string& name)
{
  vtkNew<vtkFloatArray> numbers;
  numbers->SetName("number");
  vtkNew<vtkFloatArray> milliseconds;
  milliseconds->SetName(name.c_str());
  for (const auto& [number, value] : points)
  {
    numbers->InsertNextValue(static_cast<float>(number));
    milliseconds->InsertNextValue(static_cast<float>(value));
  }
  auto table = vtkSmartPointer<vtkTable>::New();
  table->AddColumn(numbers);
  table->AddColumn(milliseconds);
  return table;
}

} // namespace

void plotGrowth(const std::vector<CostGrowth>& growths, const std::string& file)
{
  vtkNew<vtkChartXY> chart;
  chart->SetShowLegend(true);
  chart->GetLegend()->SetInline(false); // beside the curves
  chart->SetTitle("Milliseconds of a frame (thick), and of its shadows (thin)");
  for (const int side : {vtkAxis::LEFT, vtkAxis::BOTTOM})
  {
    chart->GetAxis(side)->SetLogScale(true);
  }
  chart->GetAxis(vtkAxis::LEFT)->SetTitle("ms");
  chart->GetAxis(vtkAxis::BOTTOM)->SetTitle("triangles, instances or lights");
  constexpr std::array<std::array<unsigned char, 3>, 3> colors = {{{200, 60, 40}, {40, 110, 190}, {40, 150, 80}}};
  for (std::size_t i = 0; i < growths.size(); ++i)
  {
    for (const bool shadows : {false, true})
    {
      vtkPlot* plot = chart->AddPlot(vtkChart::LINE);
      plot->SetInputData(makeTable(shadows ? growths[i].shadows : growths[i].frames,
                                   growths[i].against + (shadows ? ": shadows" : "")),
                         0, 1);
      plot->SetColor(colors[i % 3][0], colors[i % 3][1], colors[i % 3][2], 255);
      plot->SetWidth(shadows ? 1.0f : 3.0f);
    }
  }
  vtkNew<vtkContextActor> actor;
  actor->GetScene()->AddItem(chart);
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1.0, 1.0, 1.0);
  renderer->AddActor(actor);
  vtkNew<vtkHeadlessRenderWindow> window;
  window->SetSize(800, 560);
  window->AddRenderer(renderer);
  actor->GetScene()->SetRenderer(renderer);
  window->Render();
  vtkNew<vtkSVGExporter> exporter;
  exporter->SetRenderWindow(window);
  exporter->SetFileName(file.c_str());
  exporter->Write();
  if (!std::ifstream(file))
  {
    throw std::runtime_error("--plot: cannot write " + file);
  }
}

} // namespace shadow::benchmarks
