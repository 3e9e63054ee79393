// Windows that share actors, mappers and passes, each of which is released, replaced or deleted at any time:
// every picture is that of a window that shares nothing. Run with headless windows, by OSMesa and by EGL, and
// with windows of X.

#include <gtest/gtest.h>

#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "SharedWindows.h"
#include "WindowUnderTest.h"

using namespace shadow::test;

namespace
{

constexpr SharedWindows::Drawing allDrawings[] = {
    SharedWindows::Drawing::Plain, SharedWindows::Drawing::Steps, SharedWindows::Drawing::Shadows,
    SharedWindows::Drawing::Lines, SharedWindows::Drawing::LinesOverShadows};

class SharedWindowsTest : public testing::Test
{
protected:
  void SetUp() override
  {
    const std::string reason = whyThereIsNoWindow();
    if (!reason.empty())
    {
      GTEST_SKIP() << reason;
    }
  }

  /// What @p operation does, while window @p current is current.
  static void run(SharedWindows& windows, const SharedWindows::Operation& operation, std::size_t one,
                  std::size_t other, std::size_t current)
  {
    windows.getWindow(current)->MakeCurrent();
    const bool wasCurrent = windows.getWindow(current)->IsCurrent();
    (windows.*operation.run)(one, other);
    if (operation.keepsContext && wasCurrent)
    {
      EXPECT_TRUE(windows.getWindow(current)->IsCurrent()) << operation.name;
    }
  }
};

} // namespace

TEST_F(SharedWindowsTest, InTurns_EachKeepsItsPicture)
{
  for (const SharedWindows::Drawing drawing : allDrawings)
  {
    SharedWindows windows(drawing);
    for (std::size_t frame = 0; frame < 3 * SharedWindows::windowCount; ++frame)
    {
      EXPECT_EQ(windows.countWrong(frame % SharedWindows::windowCount), 0u)
          << "drawing " << static_cast<int>(drawing) << " frame " << frame;
    }
  }
}

TEST_F(SharedWindowsTest, AnyOperation_AnotherWindowCurrent_EveryPictureStays)
{
  for (const SharedWindows::Drawing drawing :
       {SharedWindows::Drawing::Shadows, SharedWindows::Drawing::LinesOverShadows})
  {
    for (const SharedWindows::Operation& operation : SharedWindows::operations())
    {
      // Drawn next is the window that was changed, or first one that was not.
      for (const std::size_t next : {0u, 1u})
      {
        SharedWindows windows(drawing);
        for (std::size_t one = 0; one < SharedWindows::windowCount; ++one)
        {
          windows.getWindow(one)->Render();
        }
        run(windows, operation, 0, 1, 2);
        for (std::size_t frame = next; frame < next + 4; ++frame)
        {
          EXPECT_EQ(windows.countWrong(frame % SharedWindows::windowCount), 0u)
              << operation.name << ", drawing " << static_cast<int>(drawing) << ", picture " << frame;
        }
      }
    }
  }
}

TEST_F(SharedWindowsTest, RandomWalk_EveryPictureIsThatOfAWindowOfItsOwn)
{
  const std::vector<SharedWindows::Operation>& operations = SharedWindows::operations();
  for (unsigned int seed = 1; seed <= 10; ++seed)
  {
    std::mt19937 random(seed);
    const auto any = [&random](std::size_t count) { return random() % count; };
    SharedWindows windows(allDrawings[any(std::size(allDrawings))]);
    std::string story;
    for (int step = 0; step < 40; ++step)
    {
      const SharedWindows::Operation& operation = operations[any(operations.size())];
      const std::size_t one = any(SharedWindows::windowCount);
      const std::size_t other = any(SharedWindows::windowCount);
      const std::size_t drawn = any(SharedWindows::windowCount);
      story += operation.name + " (" + std::to_string(one) + ", " + std::to_string(other) + "), draw " +
               std::to_string(drawn) + "; ";
      run(windows, operation, one, other, any(SharedWindows::windowCount));
      // Some steps go undrawn.
      if (any(3) != 0)
      {
        ASSERT_EQ(windows.countWrong(drawn), 0u) << "seed " << seed << ": " << story;
      }
    }
  }
}

TEST_F(SharedWindowsTest, NoneCurrent_AnyOperation_NoneIsCurrentAfterwards)
{
  if (!makeNoneCurrent())
  {
    GTEST_SKIP() << "VTK's windows of this kind do not come back to no context";
  }
  for (const SharedWindows::Operation& operation : SharedWindows::operations())
  {
    SharedWindows windows(SharedWindows::Drawing::LinesOverShadows);
    windows.getWindow(0)->Render();
    windows.getWindow(1)->Render();
    if (operation.keepsContext)
    {
      makeNoneCurrent();
      (windows.*operation.run)(0, 1);
      for (std::size_t one = 0; one < SharedWindows::windowCount; ++one)
      {
        EXPECT_FALSE(windows.getWindow(one)->IsCurrent()) << operation.name << ", window " << one;
      }
    }
  }
}
