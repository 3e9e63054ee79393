// Lines and what the pass does not know: opaque props hide them, translucent ones tint them, overlays lie
// over them.

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <string>

#include <gtest/gtest.h>

#include <vtkActor2D.h>
#include <vtkCamera.h>
#include <vtkCubeSource.h>
#include <vtkGlyph3DMapper.h>
#include <vtkImageActor.h>
#include <vtkImageMapper3D.h>
#include <vtkImageSlice.h>
#include <vtkImageSliceMapper.h>
#include <vtkLODProp3D.h>
#include <vtkPlaneSource.h>
#include <vtkPoints.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty.h>
#include <vtkProperty2D.h>
#include <vtkShaderProperty.h>

#include "OutlineBall.h"

using namespace shadow::test;

namespace
{

constexpr double side = 0.5; ///< of a square prop

vtkSmartPointer<vtkPolyDataMapper> makeSquareMapper()
{
  vtkNew<vtkPlaneSource> square;
  square->SetOrigin(0.0, 0.0, 0.0);
  square->SetPoint1(side, 0.0, 0.0);
  square->SetPoint2(0.0, side, 0.0);
  auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
  mapper->SetInputConnection(square->GetOutputPort());
  return mapper;
}

vtkSmartPointer<vtkImageData> makeSquareImage()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(11, 11, 1);
  image->SetSpacing(side / 10.0, side / 10.0, 1.0);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  std::fill_n(static_cast<unsigned char*>(image->GetScalarPointer()), 363, static_cast<unsigned char>(180));
  return image;
}

/// A square in z = 0 with a corner at the origin.
using MakeProp = std::function<vtkSmartPointer<vtkProp3D>()>;

std::map<std::string, MakeProp> opaqueProps()
{
  std::map<std::string, MakeProp> props;
  props["vtkImageActor"] = []
  {
    auto actor = vtkSmartPointer<vtkImageActor>::New();
    actor->GetMapper()->SetInputData(makeSquareImage());
    return actor;
  };
  props["vtkImageSlice"] = []
  {
    vtkNew<vtkImageSliceMapper> mapper;
    mapper->SetInputData(makeSquareImage());
    auto slice = vtkSmartPointer<vtkImageSlice>::New();
    slice->SetMapper(mapper);
    return slice;
  };
  props["vtkLODProp3D"] = []
  {
    auto prop = vtkSmartPointer<vtkLODProp3D>::New();
    prop->AddLOD(makeSquareMapper(), 0.0);
    return prop;
  };
  props["vtkGlyph3DMapper"] = []
  {
    vtkNew<vtkPoints> points;
    points->InsertNextPoint(0.5 * side, 0.5 * side, 0.0);
    vtkNew<vtkPolyData> places;
    places->SetPoints(points);
    vtkNew<vtkCubeSource> cube;
    cube->SetXLength(side);
    cube->SetYLength(side);
    cube->SetZLength(0.01);
    vtkNew<vtkGlyph3DMapper> mapper;
    mapper->SetInputData(places);
    mapper->SetSourceConnection(cube->GetOutputPort());
    mapper->ScalingOff();
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(mapper);
    return actor;
  };
  props["moved vertices"] = []
  {
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(makeSquareMapper());
    actor->GetShaderProperty()->AddVertexShaderReplacement(
        "//VTK::PositionVC::Impl", true,
        "//VTK::PositionVC::Impl\ngl_Position = MCDCMatrix * (vertexMC + vec4(0.0, 0.0, 0.01, 0.0));\n", false);
    return actor;
  };
  return props;
}

/// The ball seen along z, with a prop before or behind its right rim.
class RimScene : public OutlineBall
{
public:
  RimScene(int technique, bool parallel, int samples)
  {
    this->window->SetMultiSamples(samples);
    this->lookFrom(0.0, 0.0, 1.0);
    this->renderer->GetActiveCamera()->SetParallelProjection(parallel);
    this->renderer->GetActiveCamera()->SetClippingRange(0.5, 20.0);
    this->outlines->SetTechnique(technique);
    this->outlines->SetLineWidth(5.0);
  }

  /// With its middle at the height of the ball's, where the rim passes through it.
  void place(vtkProp3D* prop, double z)
  {
    prop->SetPosition(0.5 - 0.5 * side, 1.0 - 0.5 * side, z);
    this->renderer->AddViewProp(prop);
  }

  /// Line pixels inside the placed square, a pixel and a half along its rim left out.
  int countLinesInSquare(const Pixels& lines, double z)
  {
    const std::array<int, 2> low = this->toPixel({0.5 - 0.5 * side, 1.0 - 0.5 * side, z});
    const std::array<int, 2> high = this->toPixel({0.5 + 0.5 * side, 1.0 + 0.5 * side, z});
    int count = 0;
    for (int y = low[1] + 2; y <= high[1] - 2; ++y)
    {
      for (int x = low[0] + 2; x <= high[0] - 2; ++x)
      {
        count += lines[static_cast<std::size_t>(y * this->renderer->GetSize()[0] + x)] != 0 ? 1 : 0;
      }
    }
    return count;
  }
};

void forEachWay(const std::function<void(RimScene&, const std::string&)>& test)
{
  for (const int technique : {vtkSilhouettePass::TECHNIQUE_RECTANGLES, vtkSilhouettePass::TECHNIQUE_FACES})
  {
    for (const bool parallel : {false, true})
    {
      for (const int samples : {0, 4})
      {
        RimScene scene(technique, parallel, samples);
        test(scene, std::string("technique ") + std::to_string(technique) + (parallel ? ", parallel" : "") +
                        ", samples " + std::to_string(samples));
      }
    }
  }
}

} // namespace

TEST(OutlineWindowDepth, OpaquePropInFront_HidesLines_BehindNone)
{
  for (const auto& [name, make] : opaqueProps())
  {
    forEachWay(
        [&name = name, &make = make](RimScene& scene, const std::string& way)
        {
          const Pixels without = scene.renderLines();
          ASSERT_GT(scene.countLinesInSquare(without, 1.0), 50) << way;
          const vtkSmartPointer<vtkProp3D> prop = make();
          scene.place(prop, 1.0);
          // With a near plane so close all depths are nearly the same.
          for (const double nearest : {0.5, 1e-3})
          {
            scene.renderer->GetActiveCamera()->SetClippingRange(nearest, 20.0);
            const Pixels behindProp = scene.renderLines();
            EXPECT_EQ(scene.countLinesInSquare(behindProp, 1.0), 0)
                << name << " before the ball, " << way << ", near plane at " << nearest;
          }
          scene.renderer->GetActiveCamera()->SetClippingRange(0.5, 20.0);
          prop->SetPosition(prop->GetPosition()[0], prop->GetPosition()[1], -0.1);
          EXPECT_EQ(countDifferent(scene.renderLines(), without), 0u) << name << " behind the rim, " << way;
        });
  }
}

TEST(OutlineWindowDepth, HiddenEdges_ShowBehindOpaqueProp)
{
  RimScene scene(vtkSilhouettePass::TECHNIQUE_RECTANGLES, false, 0);
  const vtkSmartPointer<vtkProp3D> prop = opaqueProps().at("vtkImageActor")();
  scene.place(prop, 1.0);
  const Pixels without = scene.renderPicture();
  scene.outlines->HiddenEdgesOn();
  scene.outlines->SetHiddenColor(1.0, 0.0, 0.0);
  EXPECT_GT(countDifferent(scene.renderPicture(), without, 40), 50u);
}

// VTK pulls wires nearer, and wide ones reach over the rim of what they lie on.
TEST(OutlineWindowDepth, WiresOnASurface_LeaveItsLines)
{
  forEachWay(
      [](RimScene& scene, const std::string& way)
      {
        for (const auto& eye : {glm::dvec3(0.0, 0.0, 1.0), {0.0, 1.0, 0.01}, {0.7, 0.2, 0.7}})
        {
          scene.lookFrom(eye.x, eye.y, eye.z);
          scene.renderer->ResetCameraClippingRange();
          scene.outlines->SetLineWidth(2.0);
          const Pixels without = scene.renderLines();
          vtkActor* wires = scene.addMapper(scene.ballActor->GetMapper());
          wires->GetProperty()->SetRepresentationToWireframe();
          for (const float width : {1.0f, 3.0f, 5.0f})
          {
            wires->GetProperty()->SetLineWidth(width);
            EXPECT_EQ(countDifferent(scene.renderLines(), without), 0u)
                << way << ", width " << width << ", eye " << eye.y;
          }
          scene.renderer->RemoveActor(wires);
        }
      });
}

TEST(OutlineWindowDepth, LayerThatPreservesDepth_HiddenByTheLayerBelow)
{
  RimScene below(vtkSilhouettePass::TECHNIQUE_RECTANGLES, false, 0);
  vtkNew<vtkRenderer> above;
  vtkRenderer* scene = below.renderer;
  below.window->SetNumberOfLayers(2);
  // The ball moves into the upper layer, what hides it stays in the lower one.
  above->SetLayer(1);
  above->SetActiveCamera(scene->GetActiveCamera());
  scene->SetPass(nullptr);
  above->AddViewProp(below.ballActor);
  scene->RemoveViewProp(below.ballActor);
  vtkNew<vtkActor> square;
  square->SetMapper(makeSquareMapper());
  below.place(square, 1.0);
  above->SetPass(below.outlines);
  below.window->AddRenderer(above);
  above->PreserveDepthBufferOff();
  EXPECT_GT(below.countLinesInSquare(below.renderLines(), 1.0), 50);
  above->PreserveDepthBufferOn();
  EXPECT_EQ(below.countLinesInSquare(below.renderLines(), 1.0), 0);
}

TEST(OutlineWindowDepth, TranslucentProp_TintsLinesBehindIt_NotThoseInFront)
{
  for (const bool shadows : {false, true})
  {
    forEachWay(
        [shadows](RimScene& scene, const std::string& way)
        {
          scene.outlines->SmoothOff();
          scene.outlines->SetDelegatePass(shadows ? scene.pass.GetPointer() : nullptr);
          vtkNew<vtkActor> glass;
          glass->SetMapper(makeSquareMapper());
          glass->GetProperty()->SetOpacity(0.5);
          glass->GetProperty()->SetColor(0.9, 0.2, 0.2);
          glass->GetProperty()->LightingOff();
          scene.place(glass, 1.0);
          const glm::dvec3 onRim(0.5, 1.0, 0.0);
          const std::array<int, 3> tinted = scene.colourAt(onRim);
          EXPECT_NEAR(tinted[0], 0.5 * 0.9 * 255.0, 4.0) << way;
          EXPECT_NEAR(tinted[1], 0.5 * 0.2 * 255.0, 4.0) << way;
          glass->SetPosition(glass->GetPosition()[0], glass->GetPosition()[1], -0.6);
          const double radiusAndALittle = 0.515;
          for (const double radius : {0.49, radiusAndALittle})
          {
            const std::array<int, 3> black = scene.colourAt({radius, 1.0, 0.0});
            EXPECT_LT(black[0] + black[1] + black[2], 6) << way << " at " << radius;
          }
        });
  }
}

TEST(OutlineWindowDepth, Overlay_LiesOverLines)
{
  for (const bool shadows : {false, true})
  {
    RimScene scene(vtkSilhouettePass::TECHNIQUE_RECTANGLES, false, 0);
    scene.outlines->SetDelegatePass(shadows ? scene.pass.GetPointer() : nullptr);
    vtkNew<vtkPlaneSource> square;
    square->SetOrigin(0.0, 0.0, 0.0);
    square->SetPoint1(200.0, 0.0, 0.0);
    square->SetPoint2(0.0, 150.0, 0.0);
    vtkNew<vtkPolyDataMapper2D> mapper;
    mapper->SetInputConnection(square->GetOutputPort());
    vtkNew<vtkActor2D> sheet;
    sheet->SetMapper(mapper);
    sheet->GetProperty()->SetColor(0.2, 0.4, 0.8);
    scene.renderer->AddViewProp(sheet);
    const Pixels picture = scene.renderPicture();
    Pixels sheetAlone(picture.size());
    for (std::size_t i = 0; i < picture.size(); ++i)
    {
      sheetAlone[i] = static_cast<unsigned char>(51 << (i % 3)); // 0.2, 0.4 and 0.8
    }
    EXPECT_EQ(countDifferent(picture, sheetAlone), 0u);
  }
}
