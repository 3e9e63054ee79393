#include "OutlineError.h"

#include <stdexcept>

namespace shadow::truth
{

namespace
{

void note(std::vector<glm::ivec2>& pixels, int x, int y)
{
  if (pixels.size() < OutlineError::reportedPixels)
  {
    pixels.emplace_back(x, y);
  }
}

double shareWithout(std::size_t wrong, std::size_t all)
{
  return all == 0 ? 1.0 : 1.0 - static_cast<double>(wrong) / static_cast<double>(all);
}

} // namespace

double OutlineError::completeness() const
{
  return shareWithout(this->missing, this->certain);
}

double OutlineError::correctness() const
{
  return shareWithout(this->extra, this->drawn);
}

OutlineError compareOutline(const OutlineTruth& truth, const std::vector<unsigned char>& mask,
                            double lineWidth)
{
  if (mask.size() != static_cast<std::size_t>(truth.width()) * truth.height())
  {
    throw std::invalid_argument("the mask is not of the view's size");
  }
  OutlineError error;
  for (int y = 0; y < truth.height(); ++y)
  {
    for (int x = 0; x < truth.width(); ++x)
    {
      const bool set = mask[static_cast<std::size_t>(y) * truth.width() + x] >= 128;
      const OutlineTruth::Line line = truth.line(x, y, lineWidth);
      error.drawn += set ? 1 : 0;
      error.certain += line == OutlineTruth::Line::Yes ? 1 : 0;
      if (!set && line == OutlineTruth::Line::Yes)
      {
        ++error.missing;
        note(error.firstMissing, x, y);
      }
      if (set && line == OutlineTruth::Line::No)
      {
        ++error.extra;
        note(error.firstExtra, x, y);
        error.spikes += truth.distance(x, y) > 0.5 * lineWidth + OutlineError::spikeTolerance ? 1 : 0;
      }
    }
  }
  return error;
}

} // namespace shadow::truth
