// Mappers whose polygons are not simply their input.
#include <gtest/gtest.h>

#include <vtkDataSetMapper.h>
#include <vtkImageData.h>
#include <vtkNew.h>

#include "BallScene.h"

namespace
{

using namespace shadow::test;

vtkNew<vtkImageData> box(double lower, double upper)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 2, 2);
  image->SetOrigin(-0.4, lower, -0.4);
  image->SetSpacing(0.8, upper - lower, 0.8);
  return image;
}

TEST(Mappers, DataSetMapper_CastsAndReceivesInItsFirstFrame)
{
  // The ball's actor shows a volume mesh instead: VTK takes its surface out only when it draws for the first
  // time.
  BallScene scene;
  vtkNew<vtkDataSetMapper> mapper;
  mapper->SetInputData(box(0.6, 1.4));
  scene.ballActor->SetMapper(mapper);
  vtkNew<vtkDataSetMapper> tableMapper;
  tableMapper->SetInputConnection(scene.table->GetMapper()->GetInputConnection(0, 0));
  scene.table->SetMapper(tableMapper);

  const Pixels first = scene.renderPicture();
  EXPECT_EQ(scene.pass->GetStatus(), vtkShadowVolumePass::STATUS_OK) << scene.pass->GetStatusMessage();
  EXPECT_GT(scene.pass->GetSideTriangles(), 0);
  const Pixels second = scene.renderPicture();
  EXPECT_EQ(countDifferent(first, second), 0u);
  EXPECT_EQ(scene.maskAt(BallScene::inShadow), 0);
  EXPECT_LE(scene.compare().wrongCertain, rimPixels);
}

TEST(Mappers, DataSetMapper_FollowsNewInputAtOnce)
{
  BallScene scene;
  vtkNew<vtkDataSetMapper> mapper;
  mapper->SetInputData(box(0.6, 1.4));
  scene.ballActor->SetMapper(mapper);
  scene.renderPicture();
  mapper->SetInputData(box(1.3, 1.4));
  EXPECT_LE(scene.compare().wrongCertain, rimPixels);
}

} // namespace
