// That the judge finds what is wrong, lets pass what has no right answer, and that scenes shrink and travel
// through files.
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "FuzzSession.h"
#include "JobLines.h"
#include "SceneJson.h"
#include "SceneMaker.h"
#include "Shrinker.h"

namespace shadow::fuzz
{

namespace
{

/// A square over a floor, seen from the side, and a light straight above.
FuzzScene makePlainScene()
{
  const auto square = [](double half, double height)
  {
    const glm::dvec3 a(-half, -half, height), b(half, -half, height), c(half, half, height),
        d(-half, half, height);
    FuzzMesh mesh;
    mesh.triangles = {{a, b, c}, {a, c, d}};
    return mesh;
  };
  FuzzScene scene;
  scene.name = "plain";
  scene.meshes = {square(0.5, 1.0), square(4.0, 0.0)};
  scene.camera.position = {0.5, -6.0, 4.0};
  scene.camera.viewUp = {0.0, 0.0, 1.0};
  scene.camera.clippingRange = {1.0, 20.0};
  scene.light.position = {0.1, 0.2, 5.0};
  return scene;
}

/// Turns some pixels of a mask over, from one that is neither near the border nor at an edge of the shadow.
void spoil(DrawnMask& drawn, int count)
{
  for (int i = 0; i < count; ++i)
  {
    unsigned char& value = drawn.mask[static_cast<std::size_t>(20 * 160 + 20 + i)];
    value = static_cast<unsigned char>(255 - value);
  }
}

} // namespace

TEST(FuzzJudge, PlainScene_EveryMethod_IsRight)
{
  FuzzSession session;
  FuzzScene scene = makePlainScene();
  scene.configs = listEveryConfig();
  const DrawnScene drawn = session.draw(scene);
  const auto dark = std::count(drawn.truth->getMask().begin(), drawn.truth->getMask().end(), 0);
  EXPECT_GT(dark, 300) << "there is no shadow to be wrong about";
  EXPECT_GT(drawn.masks.size(), 40u) << "z-pass is left out, though nothing is near the eye";
  const SceneVerdict verdict = judgeMasks(*drawn.truth, drawn.masks);
  EXPECT_EQ(verdict.getFault(), Fault::None) << verdict.describe();
}

TEST(FuzzJudge, PixelsTurnedOver_AreFoundAndCounted)
{
  FuzzSession session;
  DrawnScene drawn = session.draw(makePlainScene());
  const std::size_t before = judgeMasks(*drawn.truth, drawn.masks).getWorst().wrong;
  for (DrawnMask& mask : drawn.masks)
  {
    spoil(mask, 4);
  }
  const SceneVerdict verdict = judgeMasks(*drawn.truth, drawn.masks);
  EXPECT_EQ(verdict.getWorst().wrong, before + 4);
  EXPECT_EQ(verdict.getFault(), Fault::WrongMask);
  EXPECT_EQ(verdict.getWorst().first, glm::ivec2(20, 20));
  EXPECT_EQ(verdict.differing, 0u) << "all masks are wrong in the same pixels";
}

TEST(FuzzJudge, OnePixelOfOneMask_MasksDiffer)
{
  FuzzSession session;
  DrawnScene drawn = session.draw(makePlainScene());
  spoil(drawn.masks.front(), 1);
  const SceneVerdict verdict = judgeMasks(*drawn.truth, drawn.masks);
  EXPECT_EQ(verdict.differing, 1u);
  EXPECT_EQ(verdict.getFault(), Fault::MasksDiffer);
}

TEST(FuzzJudge, PictureAndRefusal_AreFaults)
{
  FuzzSession session;
  DrawnScene drawn = session.draw(makePlainScene());
  drawn.masks.front().refusal = "no";
  EXPECT_EQ(judgeMasks(*drawn.truth, drawn.masks).getFault(), Fault::Refused);
  drawn.masks.front().wrongInPicture = 3;
  EXPECT_EQ(judgeMasks(*drawn.truth, drawn.masks).getFault(), Fault::Refused);
  drawn.masks.front().wrongInPicture = 4;
  EXPECT_EQ(judgeMasks(*drawn.truth, drawn.masks).getFault(), Fault::WrongPicture);
}

TEST(FuzzJudge, PixelsAtTheEdgeOfTheShadow_AreNotCertain)
{
  FuzzSession session;
  const DrawnScene drawn = session.draw(makePlainScene());
  EXPECT_LT(drawn.truth->countCertain(), drawn.truth->getMask().size());
  EXPECT_GT(drawn.truth->countCertain(), drawn.truth->getMask().size() * 99 / 100);
}

// Half of the floor is in the shadow of a wall whose plane the light is in; whether, only the light's last
// digit tells. A little beside the plane the answer is plain.
TEST(FuzzJudge, LightInPlaneOfTriangle_CertainBesideThePlaneOnly)
{
  FuzzScene scene = makePlainScene();
  scene.meshes[0].triangles = {{glm::dvec3(-1, 0, 1), glm::dvec3(1, 0, 1), glm::dvec3(0, 0, 2)}};
  scene.light.position = {0.0, 0.0, 1.5};
  FuzzSession session;
  const auto countUncertain = [&session](const FuzzScene& some)
  {
    const DrawnScene drawn = session.draw(some);
    return drawn.truth->getMask().size() - drawn.truth->countCertain();
  };
  EXPECT_GT(countUncertain(scene), 1000u);
  scene.light.position.y = 1e-5;
  EXPECT_LT(countUncertain(scene), 300u);
  scene.light.position.y = 1e-12;
  EXPECT_LT(countUncertain(scene), 700u) << "but for the wall itself, which is grazed, the same";
}

TEST(FuzzJudge, ZPass_IsNotAskedWhereTheNearPlaneIsInShadow)
{
  FuzzScene scene = makePlainScene();
  scene.camera.position = {0.0, 0.0, 0.5};
  scene.camera.focalPoint = {1.0, 0.3, 0.0};
  scene.camera.clippingRange = {0.01, 20.0};
  scene.configs = {FuzzConfig{vtkShadowVolumePass::STENCIL_ZPASS}};
  FuzzSession session;
  const DrawnScene drawn = session.draw(scene);
  EXPECT_EQ(drawn.masks.size(), 2u);
  EXPECT_EQ(judgeMasks(*drawn.truth, drawn.masks).getFault(), Fault::None);
  scene.camera.position = {0.0, 0.0, 1.5};
  EXPECT_EQ(session.draw(scene).masks.size(), 3u);
}

// The planted fault is in the shadow of one triangle of many.
TEST(FuzzShrinker, FaultOfOneTriangle_ThatTriangleIsLeft)
{
  FuzzScene scene;
  for (std::uint64_t number = 0; scene.getTriangleCount() < 30; ++number)
  {
    scene = makeScene(7, number);
  }
  const FuzzTriangle culprit = scene.meshes.front().triangles.back();
  const FuzzScene small = shrink(scene,
                                 [&culprit](const FuzzScene& some)
                                 {
                                   return std::any_of(some.meshes.begin(), some.meshes.end(),
                                                      [&culprit](const FuzzMesh& mesh) {
                                                        return std::count(mesh.triangles.begin(),
                                                                          mesh.triangles.end(), culprit) > 0;
                                                      });
                                 });
  ASSERT_EQ(small.getTriangleCount(), 1u);
  EXPECT_EQ(small.meshes.front().triangles.front(), culprit);
  EXPECT_TRUE(small.configs.empty());
}

// Drawn and judged: a mask that lacks the shadow of the square is wrong for as long as a part of the square
// and of the floor are there.
TEST(FuzzShrinker, ShadowLeftOut_OneCasterAndItsReceiverAreLeft)
{
  FuzzSession session;
  const auto lacksShadow = [&session](const FuzzScene& some)
  {
    DrawnScene drawn = session.draw(some);
    for (DrawnMask& mask : drawn.masks)
    {
      std::fill(mask.mask.begin(), mask.mask.end(), static_cast<unsigned char>(255));
    }
    return judgeMasks(*drawn.truth, drawn.masks).getFault() == Fault::WrongMask;
  };
  FuzzScene scene = makePlainScene();
  scene.light.position.z = -5.0; // the floor's lower side alone would face the light
  scene.camera.position.z = -4.0;
  scene.meshes[0] = makePlainScene().meshes[0];
  for (FuzzTriangle& triangle : scene.meshes[0].triangles)
  {
    for (glm::dvec3& corner : triangle)
    {
      corner.z = -1.0;
    }
  }
  ASSERT_TRUE(lacksShadow(scene));
  const FuzzScene small = shrink(scene, lacksShadow);
  EXPECT_LE(small.getTriangleCount(), 2u);
  EXPECT_TRUE(lacksShadow(small));
}

TEST(FuzzShrinker, NoTrialsLeft_TheSceneStays)
{
  const FuzzScene scene = makePlainScene();
  ShrinkLimits none;
  none.trials = 0;
  const FuzzScene same = shrink(scene, [](const FuzzScene&) { return true; }, none);
  EXPECT_EQ(toJson(same), toJson(scene));
}

TEST(FuzzScenes, SameNumber_SameScene)
{
  for (std::uint64_t number = 0; number < 20; ++number)
  {
    EXPECT_EQ(toJson(makeScene(3, number)), toJson(makeScene(3, number)));
    EXPECT_NE(toJson(makeScene(3, number)), toJson(makeScene(4, number)));
  }
}

TEST(FuzzScenes, ThroughAFile_EveryDigitStays)
{
  const std::string fileName = testing::TempDir() + "fuzz-scene.json";
  for (std::uint64_t number = 0; number < 20; ++number)
  {
    const FuzzScene scene = makeScene(5, number);
    writeScene(scene, fileName);
    EXPECT_EQ(toJson(readScene(fileName)), toJson(scene));
  }
  std::remove(fileName.c_str());
}

TEST(FuzzScenes, FileThatIsNone_SaysItsName)
{
  try
  {
    readScene("no-such-scene.json");
    FAIL() << "a file that is not there was read";
  }
  catch (const std::exception& error)
  {
    EXPECT_NE(std::string(error.what()).find("no-such-scene.json"), std::string::npos);
  }
}

// One of two processes crashes at its second line.
TEST(FuzzJobs, ProcessThatCrashes_IsNamedAndTheOtherGoesOn)
{
  JobLines jobs(2,
                [](int job, const JobLines::Write& write)
                {
                  for (int i = 0; i < 3; ++i)
                  {
                    if (job == 1 && i == 1)
                    {
                      std::raise(SIGKILL);
                    }
                    write(std::to_string(10 * job + i));
                  }
                });
  std::multiset<std::string> lines;
  while (const std::optional<std::string> line = jobs.read())
  {
    lines.insert(*line);
  }
  EXPECT_EQ(lines, (std::multiset<std::string>{"0", "1", "2", "10"}));
  ASSERT_EQ(jobs.getFailures().size(), 1u);
  EXPECT_EQ(jobs.getFailures().front().job, 1);
  EXPECT_EQ(jobs.getFailures().front().reason, "ended by signal 9");
}

} // namespace shadow::fuzz
