#include "TemporaryModel.h"

#include <cstdlib>
#include <filesystem>

#include <unistd.h>

#include "UserError.h"

namespace shadow::examples
{

namespace
{

[[noreturn]] void refuse(const std::string& name)
{
  throw UserError("needs a copy for its reader, which cannot be written to " + name);
}

} // namespace

TemporaryModel::TemporaryModel(const std::string& extension)
    : name((std::filesystem::temp_directory_path() / "model-XXXXXX").string() + extension)
{
  const int descriptor = mkstemps(this->name.data(), static_cast<int>(extension.size()));
  if (descriptor < 0)
  {
    refuse(this->name);
  }
  close(descriptor);
  this->stream.open(this->name, std::ios::binary);
}

TemporaryModel::~TemporaryModel()
{
  unlink(this->name.c_str());
}

void TemporaryModel::finish()
{
  this->stream.close();
  if (!this->stream)
  {
    refuse(this->name);
  }
}

} // namespace shadow::examples
