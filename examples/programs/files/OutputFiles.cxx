#include "OutputFiles.h"

#include "UserError.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace shadow::examples
{
namespace
{

namespace fs = std::filesystem;

fs::path folderOf(const std::string& file)
{
  const fs::path folder = fs::path(file).parent_path();
  return folder.empty() ? fs::path(".") : folder;
}

std::string lowerCase(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

// Where writing a name leads to.
struct Target
{
  std::string name;    ///< through symbolic links, also to what is not there yet
  bool inPlace = false; ///< a device, a pipe, or a descriptor of a process: it has to stay what it is
};

Target findTarget(const std::string& file)
{
  constexpr int mostLinks = 40; // as many as Linux follows
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status))
  {
    return {file, true};
  }
  fs::path path(file);
  for (int link = 0; fs::is_symlink(path, error); ++link)
  {
    // As /dev/stdout: what it leads to is open already, and whoever opened it reads that.
    if (fs::canonical(folderOf(path.string()), error).string().rfind("/proc/", 0) == 0)
    {
      return {file, true};
    }
    const fs::path next = fs::read_symlink(path, error);
    if (error || link == mostLinks)
    {
      throw UserError(file + ": the symbolic link leads nowhere");
    }
    path = next.is_absolute() ? next : path.parent_path() / next;
  }
  return {path.string(), false};
}

// @return false with errno set when not everything was written
bool writeAll(int descriptor, const std::string& content)
{
  std::size_t done = 0;
  while (descriptor >= 0 && done < content.size())
  {
    const ssize_t count = ::write(descriptor, content.data() + done, content.size() - done);
    if (count < 0 && errno != EINTR)
    {
      return false;
    }
    done += count > 0 ? static_cast<std::size_t>(count) : 0;
  }
  return descriptor >= 0;
}

// To a device or a pipe, as it is. A pipe that nobody reads makes no signal, but an error like any other.
bool writeInPlace(const std::string& file, const std::string& content)
{
  const int descriptor = open(file.c_str(), O_WRONLY | O_NOCTTY | O_CLOEXEC);
  const auto previous = std::signal(SIGPIPE, SIG_IGN);
  const bool written = writeAll(descriptor, content);
  const int cause = errno;
  std::signal(SIGPIPE, previous);
  const bool closed = descriptor >= 0 && close(descriptor) == 0;
  errno = written ? errno : cause;
  return written && closed;
}

// Removes an unfinished file when something goes wrong on the way.
class TemporaryFile
{
public:
  explicit TemporaryFile(const std::string& target)
      : name(target + ".XXXXXX"), descriptor(mkstemp(this->name.data()))
  {
  }
  ~TemporaryFile()
  {
    if (this->descriptor >= 0)
    {
      close(this->descriptor);
      unlink(this->name.c_str());
    }
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  bool write(const std::string& content) const { return writeAll(this->descriptor, content); }

  bool becomes(const std::string& target)
  {
    // mkstemp lets only the owner read; a picture gets the mode that any new file would have
    const mode_t mask = umask(0);
    umask(mask);
    if (fchmod(this->descriptor, 0666 & ~mask) != 0 || std::rename(this->name.c_str(), target.c_str()) != 0)
    {
      return false;
    }
    close(this->descriptor);
    this->descriptor = -1;
    return true;
  }

private:
  std::string name;
  int descriptor;
};

} // namespace

void checkTarget(const std::string& option, const std::string& file, const std::string& extension)
{
  const fs::path path(file);
  std::error_code error;
  if (!extension.empty() && lowerCase(path.extension().string()) != extension)
  {
    throw UserError(option + ": " + file + " does not end in " + extension);
  }
  const Target target = findTarget(file);
  if (target.inPlace)
  {
    if (fs::is_socket(path, error) || access(file.c_str(), W_OK) != 0)
    {
      throw UserError(option + ": " + file + " may not be written to");
    }
    return;
  }
  const fs::path folder = folderOf(target.name);
  if (!fs::is_directory(folder, error))
  {
    throw UserError(option + ": there is no folder " + folder.string());
  }
  if (access(folder.c_str(), W_OK | X_OK) != 0)
  {
    throw UserError(option + ": the folder " + folder.string() + " may not be written to");
  }
  if (path.filename().empty() || fs::is_directory(path, error))
  {
    throw UserError(option + ": " + file + " is a folder");
  }
}

bool isSameFile(const std::string& a, const std::string& b)
{
  std::error_code error;
  if (fs::equivalent(a, b, error))
  {
    return true;
  }
  return fs::path(a).filename() == fs::path(b).filename() && fs::equivalent(folderOf(a), folderOf(b), error);
}

std::string numberedName(const std::string& file, const std::string& number)
{
  const fs::path path(file);
  return (path.parent_path() / (path.stem().string() + "-" + number + path.extension().string())).string();
}

void writeFile(const std::string& file, const std::string& content)
{
  const Target target = findTarget(file);
  if (target.inPlace)
  {
    if (!writeInPlace(target.name, content))
    {
      throw UserError(file + ": cannot be written: " + std::strerror(errno));
    }
    return;
  }
  TemporaryFile temporary(target.name);
  if (!temporary.write(content) || !temporary.becomes(target.name))
  {
    throw UserError(file + ": cannot be written: " + std::strerror(errno));
  }
}

void writePng(const std::string& file, vtkImageData* image)
{
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(image);
  writer->WriteToMemoryOn();
  writer->Write();
  vtkUnsignedCharArray* bytes = writer->GetResult();
  if (bytes == nullptr || bytes->GetNumberOfValues() == 0)
  {
    throw UserError(file + ": the picture could not be turned into a PNG");
  }
  const auto size = static_cast<std::size_t>(bytes->GetNumberOfValues());
  writeFile(file, std::string(reinterpret_cast<const char*>(bytes->GetPointer(0)), size));
}

} // namespace shadow::examples
