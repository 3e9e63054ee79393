// Texels that are split over rows and layers come back as they were given.

#include <gtest/gtest.h>

#include <cstdint>
#include <numeric>
#include <string>
#include <vector>

#include "GLInspection.h"
#include "GpuScene.h"
#include "OpenGL.h"
#include "TexelArray.h"
#include "TexelReadBack.h"

using namespace shadow;
using namespace shadow::test;

namespace
{

std::vector<std::uint32_t> countUp(std::size_t words, std::uint32_t first)
{
  std::vector<std::uint32_t> values(words);
  std::iota(values.begin(), values.end(), first);
  return values;
}

std::vector<std::uint32_t> readAll(GpuWindow& window, const TexelArray& texels)
{
  TexelReadBack readBack;
  std::vector<std::uint32_t> words;
  readBack.start(window.getState(), texels);
  EXPECT_TRUE(readBack.fetch(words));
  readBack.release();
  return words;
}

} // namespace

TEST(TexelArray, AnySizeSide16_TexelsComeBack)
{
  GpuWindow window;
  TexelArray texels(TexelFormat::UInt2, 16);
  std::string error;
  for (const std::size_t size : {1u, 15u, 16u, 17u, 255u, 256u, 257u, 511u, 513u, 5000u})
  {
    ASSERT_TRUE(texels.allocate(size, error)) << error;
    EXPECT_EQ(texels.getSize(), size);
    EXPECT_LE(texels.getWidth(), 16);
    EXPECT_LE(texels.getHeight(), 16);
    EXPECT_EQ(texels.getLayers(), static_cast<int>((size + 255) / 256));
    std::size_t inLayers = 0;
    for (int layer = 0; layer < texels.getLayers(); ++layer)
    {
      EXPECT_EQ(texels.getFirstOfLayer(layer), inLayers);
      inLayers += texels.getCountOfLayer(layer);
    }
    EXPECT_EQ(inLayers, size);
    const std::vector<std::uint32_t> words = countUp(2 * size, 7);
    texels.upload(words.data(), 0, size);
    EXPECT_EQ(readAll(window, texels), words) << size;
  }
  texels.release();
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST(TexelArray, AnyRangeUploaded_NothingElseChanges)
{
  GpuWindow window;
  TexelArray texels(TexelFormat::UInt1, 16);
  std::string error;
  ASSERT_TRUE(texels.allocate(700, error));
  std::vector<std::uint32_t> expected = countUp(700, 0);
  texels.upload(expected.data(), 0, 700);
  std::uint32_t next = 1000;
  for (const auto& [first, count] : {std::pair<std::size_t, std::size_t>{0, 1},
                                     {3, 9},
                                     {5, 11},
                                     {5, 12},
                                     {5, 43},
                                     {16, 16},
                                     {240, 40},
                                     {255, 2},
                                     {200, 400},
                                     {690, 10},
                                     {30, 0},
                                     {250, 262}})
  {
    const std::vector<std::uint32_t> part = countUp(count, next);
    next += 1000;
    texels.upload(part.data(), first, count);
    std::copy(part.begin(), part.end(), expected.begin() + static_cast<std::ptrdiff_t>(first));
    ASSERT_EQ(readAll(window, texels), expected) << first << " + " << count;
  }
  texels.release();
}

TEST(TexelArray, EveryFormat_TexelsComeBack)
{
  GpuWindow window;
  for (const TexelFormat format : {TexelFormat::UInt1, TexelFormat::UInt2, TexelFormat::UInt4,
                                   TexelFormat::Float1, TexelFormat::Float2, TexelFormat::Float4})
  {
    TexelArray texels(format, 32);
    std::string error;
    ASSERT_TRUE(texels.allocate(3000, error)) << error;
    // As floats: ordinary numbers from 1 up.
    const std::vector<std::uint32_t> words =
        countUp(3000u * static_cast<std::size_t>(texels.getChannels()), 0x3f800000u);
    texels.upload(words.data(), 0, 3000);
    EXPECT_EQ(readAll(window, texels), words) << texels.getChannels() << " channels";
    EXPECT_GE(texels.getMemorySize(), 4 * words.size());
    texels.release();
  }
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST(TexelArray, UsualSide_NearlySquare)
{
  GpuWindow window;
  TexelArray texels(TexelFormat::UInt2);
  std::string error;
  ASSERT_TRUE(texels.allocate(69451, error)) << error;
  EXPECT_EQ(texels.getWidth(), 512);
  EXPECT_EQ(texels.getHeight(), 136);
  EXPECT_EQ(texels.getLayers(), 1);
  texels.release();
}

TEST(TexelArray, MoreThanAllLayersHold_Refused)
{
  GpuWindow window;
  TexelArray texels(TexelFormat::UInt2, 2);
  GLint layers = 0;
  glGetIntegerv(GL_MAX_ARRAY_TEXTURE_LAYERS, &layers);
  const auto most = 4 * static_cast<std::size_t>(layers);
  std::string error;
  EXPECT_TRUE(texels.allocate(most, error));
  EXPECT_TRUE(error.empty());
  EXPECT_FALSE(texels.allocate(most + 1, error));
  EXPECT_NE(error.find(std::to_string(most + 1)), std::string::npos) << error;
  EXPECT_EQ(texels.getSize(), 0u);
  EXPECT_EQ(texels.getTexture(), 0u);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST(TexelArray, UploadAndReadBack_GLAsFound)
{
  GpuWindow window;
  TexelArray texels(TexelFormat::UInt4, 8);
  TexelReadBack readBack;
  std::string error;
  GLuint other = 0;
  glGenTextures(1, &other);
  glBindTexture(GL_TEXTURE_2D_ARRAY, other);
  // As somebody else may have left it.
  glPixelStorei(GL_UNPACK_ALIGNMENT, 8);
  glPixelStorei(GL_UNPACK_ROW_LENGTH, 5);
  glPixelStorei(GL_PACK_ROW_LENGTH, 100);
  const GLStateValues before = readGLState();
  const std::vector<std::uint32_t> words = countUp(4 * 333, 0);
  ASSERT_TRUE(texels.allocate(333, error));
  texels.upload(words.data(), 0, 333);
  readBack.start(window.getState(), texels);
  EXPECT_TRUE(readBack.isStarted());
  std::vector<std::uint32_t> fetched;
  EXPECT_TRUE(readBack.fetch(fetched));
  EXPECT_FALSE(readBack.isStarted());
  EXPECT_FALSE(readBack.fetch(fetched)) << "only once";
  EXPECT_EQ(readGLState(), before);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
  glPixelStorei(GL_PACK_ROW_LENGTH, 0);
  glDeleteTextures(1, &other);
  texels.release();
  readBack.release();
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST(TexelReadBack, ChangedAfterStart_FetchesWhatWasThere)
{
  GpuWindow window;
  TexelArray texels(TexelFormat::UInt2, 16);
  TexelReadBack readBack;
  std::string error;
  ASSERT_TRUE(texels.allocate(1000, error));
  const std::vector<std::uint32_t> before = countUp(2000, 1);
  const std::vector<std::uint32_t> after = countUp(2000, 500000);
  texels.upload(before.data(), 0, 1000);
  readBack.start(window.getState(), texels);
  texels.upload(after.data(), 0, 1000);
  glFinish();
  EXPECT_TRUE(readBack.isReady());
  std::vector<std::uint32_t> words;
  ASSERT_TRUE(readBack.fetch(words));
  EXPECT_EQ(words, before);
  EXPECT_GE(readBack.getTimes().start, 0.0);
  EXPECT_GT(readBack.getTimes().getSum(), 0.0);
  texels.release();
  readBack.release();
}
