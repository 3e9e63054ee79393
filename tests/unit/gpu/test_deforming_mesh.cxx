// A mesh whose points move: what goes to the GPU again, and that every method draws what it would draw of a
// mesh that is new.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include <vtkActor.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include "BallScene.h"
#include "DeformedMesh.h"
#include "OutlineBall.h"
#include "SilhouetteMethods.h"
#include "SoupPolyData.h"
#include "UploadCounter.h"

using namespace shadow;
using namespace shadow::test;

namespace
{

void show(vtkPolyData* polyData, const TriangleSoup& soup)
{
  const vtkSmartPointer<vtkPolyData> shown = toPolyData(soup);
  polyData->SetPoints(shown->GetPoints());
  polyData->SetPolys(shown->GetPolys());
}

/// The ball of a BallScene is a mesh that changes.
class DeformingScene : public BallScene
{
public:
  explicit DeformingScene(const TriangleSoup& soup)
  {
    this->ballActor->SetPosition(0.0, 1.0, 0.0);
    vtkPolyDataMapper::SafeDownCast(this->ballActor->GetMapper())->SetInputData(this->polyData);
    ::show(this->polyData, soup);
  }

  std::vector<Pixels> renderMasks(vtkShadowVolumePass* by)
  {
    this->renderer->SetPass(by);
    this->window->Render();
    std::vector<Pixels> masks;
    for (int light = 0; light < 2; ++light)
    {
      vtkNew<vtkImageData> image;
      EXPECT_TRUE(by->GetShadowMask(light, image)) << by->GetStatusMessage();
      const auto* pixels = static_cast<const unsigned char*>(image->GetScalarPointer());
      masks.emplace_back(pixels, pixels + image->GetNumberOfPoints());
    }
    return masks;
  }

  vtkNew<vtkPolyData> polyData;
};

std::size_t countUploaded(vtkRenderWindow* window)
{
  window->MakeCurrent();
  const UploadCounter counter;
  window->Render();
  return counter.getBytes();
}

} // namespace

namespace
{

/// Renders both. @return bytes that the pass uploads: what VTK does for its own picture is found
/// out in a scene without it
std::size_t countUploadedByPass(DeformingScene& scene, DeformingScene& plain)
{
  return countUploaded(scene.window) - countUploaded(plain.window);
}

} // namespace

TEST(DeformingMesh, OnlyPositionsAreUploaded_ByEveryMethod)
{
  const TriangleSoup soup = makeTestTorus();
  const SEDGeometry geometry = build(soup);
  const std::size_t triangles = geometry.getTriangles().size();
  const std::size_t tableBytes = 16 * (triangles + geometry.getEdges().size());
  for (const int method : allMethods(BallScene().pass))
  {
    SCOPED_TRACE(nameOf(method));
    DeformingScene scene(soup);
    DeformingScene plain(soup);
    scene.pass->SetSilhouetteMethod(method);
    plain.renderer->SetPass(nullptr);
    scene.window->Render();
    plain.window->Render();
    for (const Move& move : {Move(stretch), Move([](const glm::dvec3& point) { return point * 0.75; })})
    {
      for (DeformingScene* each : {&scene, &plain})
      {
        show(each->polyData, moved(soup, move));
      }
      const std::size_t uploaded = countUploadedByPass(scene, plain);
      // Frees buffers and textures of the pass, of all meshes.
      scene.pass->ReleaseGraphicsResources(scene.window);
      const std::size_t everything = countUploaded(scene.window);
      EXPECT_GT(uploaded, 12 * geometry.getPositions().size()) << "positions are";

      const int used = scene.pass->GetUsedSilhouetteMethod();
      const bool onGPU = used >= vtkShadowVolumePass::SILHOUETTE_FACING_TEXTURE;
      const bool adjacency = used == vtkShadowVolumePass::SILHOUETTE_GEOMETRY_SHADER;
      const std::size_t topology =
          12 * triangles + (onGPU ? tableBytes : 0) + (adjacency ? 24 * triangles : 0);
      EXPECT_GE(everything, uploaded + topology);
      RecordProperty(nameOf(method), std::to_string(uploaded) + " of " + std::to_string(everything));
    }
  }
}

namespace
{

struct Step
{
  const char* name;
  TriangleSoup soup;
};

constexpr const char* grown = "a cube that has grown until its faces are large on the screen";

/// The mesh deforms, comes back, and becomes others that look much the same.
std::vector<Step> makeSteps()
{
  const TriangleSoup torus = makeTestTorus();
  std::vector<Step> steps = {{"as it is", torus},
                             {"bulged", moved(torus, bulge(0.2))},
                             {"bulged more", moved(torus, bulge(0.5))},
                             {"turned", moved(torus, turn)},
                             {"as it was", torus},
                             {"stretched", moved(torus, stretch)},
                             {"mirrored", moved(torus, [](const glm::dvec3& p) { return -p; })}};
  TriangleSoup insideOut = torus;
  turnInsideOut(insideOut);
  steps.push_back({"wound the other way", insideOut});
  steps.push_back({"bulged and wound the other way", moved(insideOut, bulge(0.3))});
  TriangleSoup open = torus;
  open.triangles.resize(open.triangles.size() / 2);
  steps.push_back({"half of it", open});
  steps.push_back({"half of it, bulged", moved(open, bulge(0.4))});
  TriangleSoup welded = open;
  welded.points[open.triangles[0][1]] = welded.points[open.triangles[0][0]];
  steps.push_back({"two points at one place", welded});
  steps.push_back({"two points at one place, bulged", moved(welded, bulge(0.3))});
  steps.push_back({"and apart again", moved(open, bulge(0.3))});
  TriangleSoup more = open;
  const auto first = static_cast<std::uint32_t>(more.points.size());
  more.points.insert(more.points.end(), {{0.0, 0.5, 0.0}, {0.3, 0.6, 0.0}, {0.0, 0.6, 0.3}});
  more.triangles.push_back({first, first + 1, first + 2});
  steps.push_back({"one more triangle", more});
  steps.push_back({"one more triangle, bulged", moved(more, bulge(0.2))});
  TriangleSoup book = makeBook(5);
  book = moved(book, [](const glm::dvec3& p) { return 0.4 * p; });
  steps.push_back({"non-manifold", book});
  steps.push_back({"non-manifold, bulged", moved(book, bulge(0.3))});
  const TriangleSoup cube = makeCube({0.0, 0.0, 0.0}, 2.0);
  steps.push_back({"a cube with short edges", moved(cube, [](const glm::dvec3& p) { return 0.3 * p; })});
  steps.push_back({grown, cube});
  return steps;
}

} // namespace

TEST(DeformingMesh, MaskIsThatOfANewPass_ByEveryMethod)
{
  const std::vector<Step> steps = makeSteps();
  for (const int method : allMethods(BallScene().pass))
  {
    for (const int stencil : {vtkShadowVolumePass::STENCIL_ZPASS, vtkShadowVolumePass::STENCIL_ZFAIL})
    {
      DeformingScene scene(steps.front().soup);
      scene.addPointLight(2.0, 3.0, 1.0);
      scene.ballActor->GetProperty()->SetBackfaceCulling(stencil == vtkShadowVolumePass::STENCIL_ZFAIL);
      scene.pass->SetSilhouetteMethod(method);
      scene.pass->SetStencilMethod(stencil);
      std::vector<Pixels> before;
      std::size_t seen = 0; // a quarter of a turn, or another winding, shows nothing new
      for (const Step& step : steps)
      {
        SCOPED_TRACE(nameOf(method) + ", " + step.name);
        show(scene.polyData, step.soup);
        const std::vector<Pixels> masks = scene.renderMasks(scene.pass);
        vtkNew<vtkShadowVolumePass> fresh;
        fresh->SetSilhouetteMethod(method);
        fresh->SetStencilMethod(stencil);
        const std::vector<Pixels> expected = scene.renderMasks(fresh);
        for (std::size_t light = 0; light < masks.size(); ++light)
        {
          // A new pass sorts the triangles anew: where two are equally deep on a rim, it may show the other
          // one.
          EXPECT_LE(countDifferent(masks[light], expected[light]), rimPixels) << "light " << light;
        }
        seen += masks != before ? 1 : 0;
        before = masks;
        fresh->ReleaseGraphicsResources(scene.window);
      }
      EXPECT_GE(seen + 4, steps.size()) << "nothing moves";
    }
  }
}

TEST(DeformingMesh, LinesAreThoseOfANewPass_ByBothTechniques)
{
  const std::vector<Step> steps = makeSteps();
  for (const int technique : {vtkSilhouettePass::TECHNIQUE_RECTANGLES, vtkSilhouettePass::TECHNIQUE_FACES})
  {
    DeformingScene scene(steps.front().soup);
    vtkNew<vtkSilhouettePass> kept;
    kept->SetTechnique(technique);
    const auto renderLines = [&](vtkSilhouettePass* by)
    {
      scene.renderer->SetPass(by);
      scene.window->Render();
      return readLines(by);
    };
    for (const Step& step : steps)
    {
      SCOPED_TRACE(step.name);
      show(scene.polyData, step.soup);
      const Pixels lines = renderLines(kept);
      const vtkIdType triangles = kept->GetLineTriangles();
      vtkNew<vtkSilhouettePass> fresh;
      fresh->SetTechnique(technique);
      EXPECT_EQ(countDifferent(lines, renderLines(fresh)), 0u);
      EXPECT_GT(countValue(lines, 255), fewestLinePixels / 2);
      const bool listsLarge = technique == vtkSilhouettePass::TECHNIQUE_FACES && step.name == grown;
      EXPECT_TRUE(!listsLarge || triangles > static_cast<vtkIdType>(step.soup.triangles.size()) + 2)
          << "none is large";
      fresh->ReleaseGraphicsResources(scene.window);
    }
  }
}

TEST(DeformingMesh, MemoryOfOutlinesIsThatOfANewPass)
{
  const TriangleSoup soup = makeTestTorus();
  DeformingScene scene(soup);
  const auto renderFacesThenRectangles = [&](vtkSilhouettePass* by, bool moves)
  {
    scene.renderer->SetPass(by);
    by->SetTechniqueToFaces();
    show(scene.polyData, moves ? moved(soup, bulge(0.2)) : soup);
    scene.window->Render();
    by->SetTechniqueToRectangles();
    if (moves)
    {
      // The normals are out of date, but stay where they are.
      show(scene.polyData, soup);
    }
    scene.window->Render();
    return by->GetMemorySize();
  };
  vtkNew<vtkSilhouettePass> still;
  vtkNew<vtkSilhouettePass> moving;
  const vtkIdType expected = renderFacesThenRectangles(still, false);
  still->ReleaseGraphicsResources(scene.window);
  const auto normals = static_cast<vtkIdType>(12 * soup.triangles.size());
  EXPECT_GT(renderFacesThenRectangles(moving, true), expected - normals / 2);
  moving->ReleaseGraphicsResources(scene.window);
}

TEST(DeformingMesh, AnotherDataSetAtEachTime_OnlyPositionsAreUploaded)
{
  const TriangleSoup soup = makeTestTorus();
  const SEDGeometry geometry = build(soup);
  DeformingScene scene(soup);
  DeformingScene plain(soup);
  plain.renderer->SetPass(nullptr);
  scene.window->Render();
  plain.window->Render();
  for (DeformingScene* each : {&scene, &plain})
  {
    vtkNew<vtkPolyData> later;
    show(later, moved(soup, stretch));
    vtkPolyDataMapper::SafeDownCast(each->ballActor->GetMapper())->SetInputData(later);
  }
  const std::size_t uploaded = countUploadedByPass(scene, plain);
  scene.pass->ReleaseGraphicsResources(scene.window);
  EXPECT_GE(countUploaded(scene.window), uploaded + 12 * geometry.getTriangles().size());
}
