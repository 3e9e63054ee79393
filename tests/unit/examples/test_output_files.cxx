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
#include <thread>
#include <utility>

#include <sys/stat.h>
#include <sys/sysmacros.h>

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

// What a name leads to is written, and every link and pipe is what it was.
TEST_F(OutputFiles, SymbolicLinks_AreFollowed)
{
  fs::create_directory(this->path("there"));
  writeFile(this->path("there/a.txt"), "first");
  fs::create_symlink("there/a.txt", this->path("link"));
  fs::create_symlink("link", this->path("link-to-link"));
  fs::create_symlink("there/new.txt", this->path("dangling"));
  for (const std::string name : {"link-to-link", "dangling"})
  {
    checkTarget("--report", this->path(name), "");
    writeFile(this->path(name), name);
    EXPECT_TRUE(fs::is_symlink(this->path(name)));
  }
  EXPECT_TRUE(fs::is_symlink(this->path("link")));
  EXPECT_EQ(contentOf(this->path("there/a.txt")), "link-to-link");
  EXPECT_EQ(contentOf(this->path("there/new.txt")), "dangling");
}

TEST_F(OutputFiles, LinksInACircle_AreRefused)
{
  fs::create_symlink("b", this->path("a"));
  fs::create_symlink("a", this->path("b"));
  EXPECT_THROW(checkTarget("--report", this->path("a"), ""), UserError);
  EXPECT_THROW(writeFile(this->path("a"), "x"), UserError);
  EXPECT_TRUE(fs::is_symlink(this->path("a")) && fs::is_symlink(this->path("b")));
}

TEST_F(OutputFiles, Pipe_IsWrittenToAndStays)
{
  const std::string pipe = this->path("pipe");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  checkTarget("--report", pipe, "");
  std::string read;
  std::thread reader([&] { read = contentOf(pipe); });
  writeFile(pipe, "through the pipe");
  reader.join();
  EXPECT_EQ(read, "through the pipe");
  EXPECT_TRUE(fs::is_fifo(pipe));
  EXPECT_EQ(this->fileCount(), 1u);
}

// A node of the kind that /dev/null is, and /dev/full, which takes nothing.
TEST_F(OutputFiles, Device_IsWrittenToAndStays)
{
  for (const auto& [name, minor] : {std::pair("null", 3u), std::pair("full", 7u)})
  {
    const std::string node = this->path(name);
    if (mknod(node.c_str(), S_IFCHR | 0600, makedev(1, minor)) != 0)
    {
      fs::create_symlink(std::string("/dev/") + name, node); // not root: the real one may be written to as well
    }
    checkTarget("--report", node, "");
    if (std::ofstream(node).is_open())
    {
      if (minor == 3u)
      {
        writeFile(node, "gone");
      }
      else
      {
        EXPECT_THROW(writeFile(node, "too much"), UserError);
      }
    }
    EXPECT_TRUE(fs::is_character_file(node));
  }
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
