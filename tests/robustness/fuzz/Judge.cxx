#include "Judge.h"

#include <algorithm>
#include <array>
#include <stdexcept>

namespace shadow::fuzz
{

namespace
{

bool isReached(unsigned char value)
{
  return value >= 128;
}

/// Adds one pixel to the verdict when it is certain.
void judgePixel(const CertainPixels& truth, const std::vector<DrawnMask>& masks, int x, int y,
                SceneVerdict& verdict)
{
  const std::size_t pixel = static_cast<std::size_t>(y) * truth.getWidth() + x;
  const bool right = isReached(truth.getMask()[pixel]);
  const bool isRight = std::all_of(masks.begin(), masks.end(), [&](const DrawnMask& drawn)
                                   { return isReached(drawn.mask[pixel]) == right; });
  if (isRight || !truth.isCertain(x, y))
  {
    return;
  }
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < masks.size(); ++i)
  {
    if (isReached(masks[i].mask[pixel]) != right)
    {
      ++wrong;
      MaskVerdict& mask = verdict.masks[i];
      mask.first = mask.wrong == 0 ? glm::ivec2(x, y) : mask.first;
      ++mask.wrong;
    }
  }
  verdict.differing += wrong > 0 && wrong < masks.size() ? 1 : 0;
}

} // namespace

std::size_t getWrongPixelLimit(std::size_t certainPixels)
{
  return std::max<std::size_t>(3, certainPixels * 20 / 1000000);
}

SceneVerdict judgeMasks(const CertainPixels& truth, const std::vector<DrawnMask>& masks, std::size_t enough)
{
  SceneVerdict verdict;
  verdict.pixels = truth.getMask().size();
  verdict.limit = getWrongPixelLimit(verdict.pixels);
  for (const DrawnMask& drawn : masks)
  {
    if (drawn.mask.size() != verdict.pixels)
    {
      throw std::invalid_argument("judgeMasks: a mask is not of the view's size");
    }
    verdict.masks.push_back({drawn.config, 0, glm::ivec2(-1), drawn.refusal, drawn.wrongInPicture});
  }
  for (int y = 0; y < truth.getHeight() && verdict.getWorst().wrong <= enough; ++y)
  {
    for (int x = 0; x < truth.getWidth(); ++x)
    {
      judgePixel(truth, masks, x, y, verdict);
    }
  }
  if (verdict.limit > getWrongPixelLimit(0))
  {
    verdict.limit = getWrongPixelLimit(truth.countCertain());
  }
  return verdict;
}

const MaskVerdict& SceneVerdict::getWorst() const
{
  return *std::max_element(this->masks.begin(), this->masks.end(),
                           [](const MaskVerdict& a, const MaskVerdict& b) { return a.wrong < b.wrong; });
}

Fault SceneVerdict::getFault() const
{
  const auto any = [this](const auto& condition)
  { return std::any_of(this->masks.begin(), this->masks.end(), condition); };
  if (any([this](const MaskVerdict& mask) { return mask.wrong > this->limit; }))
  {
    return Fault::WrongMask;
  }
  if (this->differing > 0)
  {
    return Fault::MasksDiffer;
  }
  if (any([this](const MaskVerdict& mask) { return mask.wrongInPicture > this->limit; }))
  {
    return Fault::WrongPicture;
  }
  return any([](const MaskVerdict& mask) { return !mask.refusal.empty(); }) ? Fault::Refused : Fault::None;
}

std::string SceneVerdict::describe() const
{
  std::string text;
  for (const MaskVerdict& mask : this->masks)
  {
    const std::string name = "  " + getName(mask.config) + ": ";
    if (mask.wrong > 0)
    {
      text += name + std::to_string(mask.wrong) + " wrong certain pixels, first " +
              std::to_string(mask.first.x) + ", " + std::to_string(mask.first.y) + "\n";
    }
    if (mask.wrongInPicture > 0)
    {
      text += name + "the pictures of the two compositings differ in " + std::to_string(mask.wrongInPicture) +
              " pixels\n";
    }
    if (!mask.refusal.empty())
    {
      text += name + "the pass says: " + mask.refusal + "\n";
    }
  }
  if (this->differing > 0)
  {
    text += "  masks differ in " + std::to_string(this->differing) + " certain pixels\n";
  }
  return text;
}

std::string getName(const FuzzConfig& config)
{
  constexpr std::array<const char*, 3> stencils = {"auto", "zpass", "zfail"};
  constexpr std::array<const char*, 3> buffers = {"", " stencil", " color"};
  std::string name = stencils.at(static_cast<std::size_t>(config.stencil));
  if (config.silhouette != 0)
  {
    name += " silhouette " + std::to_string(config.silhouette);
  }
  name += buffers.at(static_cast<std::size_t>(config.countBuffer));
  name += config.alone ? " alone" : "";
  return name + (config.compositing != 0 ? " additive" : "");
}

} // namespace shadow::fuzz
