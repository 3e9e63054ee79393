#include "OutputFiles.h"
#include "UserError.h"

#include <gtest/gtest.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace
{

using namespace shadow::examples;
namespace fs = std::filesystem;

class OutputFiles : public testing::Test
{
protected:
  void SetUp() override
  {
    std::string pattern = (fs::temp_directory_path() / "output-files-XXXXXX").string();
    ASSERT_NE(mkdtemp(pattern.data()), nullptr);
    this->folder = pattern;
  }
  void TearDown() override { fs::remove_all(this->folder); }

  std::string path(const std::string& name) const { return (this->folder / name).string(); }
  std::size_t fileCount() const
  {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(this->folder), fs::directory_iterator()));
  }
  static std::string contentOf(const std::string& file)
  {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  fs::path folder;
};

TEST_F(OutputFiles, NumberedName_StandsBeforeTheEnding)
{
  EXPECT_EQ(numberedName("a.b/shadow.png", "0003"), "a.b/shadow-0003.png");
  EXPECT_EQ(numberedName("shadow.v2.png", "1"), "shadow.v2-1.png");
}

TEST_F(OutputFiles, WriteFile_ReplacesAndLeavesNothingElse)
{
  writeFile(this->path("a.txt"), "first, and longer");
  writeFile(this->path("a.txt"), "second");
  EXPECT_EQ(contentOf(this->path("a.txt")), "second");
  EXPECT_EQ(this->fileCount(), 1u);
}

TEST_F(OutputFiles, WriteFile_FailedRename_LeavesNothing)
{
  fs::create_directory(this->path("a.txt"));
  EXPECT_THROW(writeFile(this->path("a.txt"), "text"), UserError);
  EXPECT_THROW(writeFile(this->path("missing/a.txt"), "text"), UserError);
  EXPECT_EQ(this->fileCount(), 1u);
}

TEST_F(OutputFiles, CheckTarget_RefusesWhatCannotBeWritten)
{
  fs::create_directory(this->path("folder.png"));
  EXPECT_NO_THROW(checkTarget("--output", this->path("a.png"), ".png"));
  EXPECT_NO_THROW(checkTarget("--output", this->path("A.PNG"), ".png"));
  EXPECT_NO_THROW(checkTarget("--report", this->path("report"), ""));
  EXPECT_THROW(checkTarget("--output", this->path("a.jpg"), ".png"), UserError);
  EXPECT_THROW(checkTarget("--output", this->path("a"), ".png"), UserError);
  EXPECT_THROW(checkTarget("--output", this->path("missing/a.png"), ".png"), UserError);
  EXPECT_THROW(checkTarget("--output", this->path("folder.png"), ".png"), UserError);
  EXPECT_EQ(this->fileCount(), 1u);
}

TEST_F(OutputFiles, IsSameFile_SeesThroughPaths)
{
  EXPECT_TRUE(isSameFile(this->path("a.png"), this->path("./a.png")));
  EXPECT_FALSE(isSameFile(this->path("a.png"), this->path("b.png")));
  writeFile(this->path("a.png"), "x");
  fs::create_symlink(this->path("a.png"), this->path("link.png"));
  EXPECT_TRUE(isSameFile(this->path("a.png"), this->path("link.png")));
}

TEST_F(OutputFiles, WritePng_ReadsBackTheSame)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(5, 3, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  auto* values = static_cast<unsigned char*>(image->GetScalarPointer());
  for (int i = 0; i < 15; ++i)
  {
    values[i] = static_cast<unsigned char>(17 * i);
  }
  writePng(this->path("a.png"), image);
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(this->path("a.png").c_str());
  reader->Update();
  const auto* read = static_cast<unsigned char*>(reader->GetOutput()->GetScalarPointer());
  EXPECT_TRUE(std::equal(values, values + 15, read));
  EXPECT_EQ(this->fileCount(), 1u);
}

} // namespace
