// A headless window through EGL, and somebody else who draws through EGL: whoever opens or ends his display, the other
// one's context stays. To be run with VTKSHADOW_HEADLESS=egl, as ctest does.

#include <gtest/gtest.h>

#include <cstdlib>
#include <memory>
#include <string>

#include <dlfcn.h>

#include "BallScene.h"
#include "EGLNeighbour.h"

using namespace shadow::test;

namespace
{

/// Steps: the window is Made and Deleted, the neighbour Opens and Ends.
constexpr const char* everyOrder[] = {"MDOE", "MODE", "MOED", "OMDE", "OMED", "OEMD"};

class HeadlessNeighbours : public testing::Test
{
protected:
  void SetUp() override
  {
    const char* chosen = std::getenv("VTKSHADOW_HEADLESS");
    if (chosen == nullptr || std::string(chosen) != "egl")
    {
      GTEST_SKIP() << "to be run with VTKSHADOW_HEADLESS=egl";
    }
    if (dlopen("libEGL.so.1", RTLD_NOW | RTLD_LOCAL) == nullptr)
    {
      GTEST_SKIP() << "there is no libEGL to test: " << dlerror();
    }
  }

  void take(char step, const EGLNeighbourKind& kind)
  {
    switch (step)
    {
      case 'M':
        this->scene = std::make_unique<BallScene>();
        this->messages = MessageCounter::observe(this->scene->window);
        break;
      case 'D':
        this->scene.reset();
        break;
      case 'O':
        this->neighbour = kind.open(kind.index);
        break;
      default:
        this->neighbour.reset();
    }
  }

  /// Both that are there draw, in turns.
  void expectDrawn(const std::string& story)
  {
    for (int turn = 0; turn < 2; ++turn)
    {
      if (this->neighbour != nullptr)
      {
        EXPECT_TRUE(this->neighbour->draws()) << story;
      }
      if (this->scene != nullptr)
      {
        EXPECT_LE(this->scene->compare().wrongCertain, rimPixels) << story;
        EXPECT_EQ(this->messages->errors, 0) << story << ": " << this->messages->last;
      }
    }
  }

  std::unique_ptr<BallScene> scene;
  vtkSmartPointer<MessageCounter> messages;
  std::unique_ptr<EGLNeighbour> neighbour;
};

} // namespace

TEST_F(HeadlessNeighbours, AnyOrder_EachKeepsItsContext)
{
  int drawing = 0;
  for (const EGLNeighbourKind& kind : listEGLNeighbours())
  {
    bool draws = true;
    for (const std::string order : everyOrder)
    {
      for (std::size_t step = 0; step < order.size() && draws; ++step)
      {
        this->take(order[step], kind);
        draws = order[step] != 'O' || this->neighbour != nullptr;
        this->expectDrawn(kind.name + ", " + order.substr(0, step + 1));
      }
    }
    drawing += draws ? 1 : 0;
    this->scene.reset();
  }
  if (drawing == 0)
  {
    GTEST_SKIP() << "EGL lists nothing that draws";
  }
}
