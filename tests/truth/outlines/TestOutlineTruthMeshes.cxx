// Outlines of real meshes, held against the truth.
#include <ostream>
#include <string>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include <vtkCamera.h>
#include <vtkOBJReader.h>

#include "MeshFiles.h"
#include "OutlineScene.h"

namespace shadow::truth
{

namespace
{

enum class Projection
{
  Perspective,
  Parallel
};

using MeshView = std::tuple<std::string, Projection>; // file

std::string nameOf(const testing::TestParamInfo<MeshView>& info)
{
  const auto& [file, projection] = info.param;
  return test::toTestName(file) + (projection == Projection::Parallel ? "_Parallel" : "_Perspective");
}

} // namespace

class MeshOutline : public testing::TestWithParam<MeshView>
{
protected:
  MeshOutline() : scene(640, 480)
  {
    const auto& [file, projection] = GetParam();
    vtkNew<vtkOBJReader> reader;
    reader->SetFileName(file.c_str());
    this->scene.addSource(reader);
    this->scene.lookFrom(0.4, 0.5, 1.0, 1.9);
    if (projection == Projection::Parallel)
    {
      vtkCamera* camera = this->scene.renderer->GetActiveCamera();
      camera->ParallelProjectionOn();
      camera->SetParallelScale(0.3 * camera->GetDistance());
      this->scene.renderer->ResetCameraClippingRange();
    }
  }

  OutlineScene scene;
};

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(MeshOutline);

TEST_P(MeshOutline, EveryWidth_LinesAreTrue)
{
  this->scene.window->Render();
  const OutlineTruth truth = this->scene.makeOutline();
  expectTrueLines(this->scene, truth);
  this->scene.outlines->SetTechniqueToFaces();
  expectTrueLines(this->scene, truth, "Faces");
}

TEST_P(MeshOutline, Creases_LinesAreTrue)
{
  this->scene.outlines->CreaseEdgesOn();
  this->scene.outlines->SetFeatureAngle(40.0);
  this->scene.window->Render();
  OutlineOptions options;
  options.creaseDegrees = 40.0;
  // A crease has its surface on both sides, which shows by its depth that it is there but not what covers the
  // line between: hidden by less than this a crease may be drawn.
  options.offsets.hidden = 0.25;
  const OutlineTruth truth = this->scene.makeOutline(options);
  expectTrueLines(this->scene, truth);
  this->scene.outlines->SetTechniqueToFaces();
  expectTrueLines(this->scene, truth, "Faces");
}

TEST_P(MeshOutline, FaceOptions_SamePicture)
{
  vtkSilhouettePass* outlines = this->scene.outlines;
  outlines->SetTechniqueToFaces();
  vtkIdType listed = 0;
  for (const double zoom : {1.0, 3.0, 40.0})
  {
    this->scene.renderer->GetActiveCamera()->Zoom(zoom);
    outlines->SplitLargeFacesOff();
    outlines->LeaveOutFlatFacesOff();
    const std::vector<unsigned char> plain = this->scene.renderLines(4.0);
    const vtkIdType all = outlines->GetLineTriangles();
    outlines->LeaveOutFlatFacesOn();
    EXPECT_TRUE(this->scene.renderLines(4.0) == plain) << "left out, zoom " << zoom;
    RecordProperty("left out", static_cast<int>(all - outlines->GetLineTriangles()));
    outlines->LeaveOutFlatFacesOff();
    outlines->SplitLargeFacesOn();
    EXPECT_TRUE(this->scene.renderLines(4.0) == plain) << "split, zoom " << zoom;
    listed += outlines->GetLineTriangles() - all;
    outlines->LeaveOutFlatFacesOn();
    EXPECT_TRUE(this->scene.renderLines(4.0) == plain) << "both, zoom " << zoom;
  }
  EXPECT_GT(listed, 0) << "no face is ever so large that it may be split";
}

INSTANTIATE_TEST_SUITE_P(Models, MeshOutline,
                         testing::Combine(testing::ValuesIn(test::findMeshFiles(SHADOW_MODELS)),
                                          testing::Values(Projection::Perspective, Projection::Parallel)),
                         nameOf);

} // namespace shadow::truth
