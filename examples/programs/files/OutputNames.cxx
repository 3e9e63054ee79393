#include "OutputNames.h"

#include "OutputFiles.h"
#include "UserError.h"

#include <algorithm>
#include <vector>

namespace shadow::examples
{
namespace
{

std::string fourDigits(int number)
{
  const std::string digits = std::to_string(number);
  return std::string(digits.size() < 4 ? 4 - digits.size() : 0, '0') + digits;
}

void refuseSame(const std::string& name, const std::vector<std::string>& others, const std::string& why)
{
  const auto same = [&name](const std::string& other) { return isSameFile(name, other); };
  if (std::any_of(others.begin(), others.end(), same))
  {
    throw UserError(name + ": " + why);
  }
}

} // namespace

OutputNames::OutputNames(const RenderOptions& given, std::size_t masks)
    : options(given), maskCount(given.mask.empty() ? 0 : masks)
{
}

std::string OutputNames::picture(int frame) const
{
  return this->options.frames ? numberedName(this->options.output, fourDigits(frame)) : this->options.output;
}

std::string OutputNames::mask(int frame, std::size_t index) const
{
  std::string name = this->options.mask;
  if (this->options.frames && !name.empty())
  {
    name = numberedName(name, fourDigits(frame));
  }
  return this->maskCount > 1 ? numberedName(name, std::to_string(index)) : name;
}

const std::string& OutputNames::report() const
{
  return this->options.report;
}

void OutputNames::check() const
{
  // One frame is enough: the names of all others differ by its number only.
  std::vector<std::string> names = {this->picture(0)};
  checkTarget("--output", names.front(), ".png");
  for (std::size_t index = 0; index < this->maskCount; ++index)
  {
    names.push_back(this->mask(0, index));
    checkTarget("--mask", names.back(), ".png");
  }
  if (!this->report().empty())
  {
    names.push_back(this->report());
    checkTarget("--report", names.back(), "");
  }
  while (!names.empty())
  {
    const std::string name = names.back();
    names.pop_back();
    refuseSame(name, names, "two outputs would have this name");
    refuseSame(name, this->options.models, "the output would take the place of a model");
  }
}

} // namespace shadow::examples
