#include "MaskError.h"

#include <cmath>
#include <numeric>
#include <stdexcept>

#include "DistanceTransform.h"

namespace shadow::truth
{

namespace
{

bool reached(unsigned char value)
{
  return value >= 128;
}

/// 1 for pixels with one of their four neighbours on the other side of the shadow's edge.
std::vector<unsigned char> boundary(const std::vector<unsigned char>& mask, int width, int height)
{
  std::vector<unsigned char> edge(mask.size(), 0);
  const auto compare = [&](std::size_t i, std::size_t j)
  {
    if (reached(mask[i]) != reached(mask[j]))
    {
      edge[i] = 1;
      edge[j] = 1;
    }
  };
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      const std::size_t i = static_cast<std::size_t>(y) * width + x;
      if (x + 1 < width)
      {
        compare(i, i + 1);
      }
      if (y + 1 < height)
      {
        compare(i, i + width);
      }
    }
  }
  return edge;
}

struct OutlineSum
{
  double sum = 0.0, most = 0.0;
  std::size_t count = 0;

  void add(const std::vector<unsigned char>& edge, const std::vector<double>& distance, double diagonal)
  {
    for (std::size_t i = 0; i < edge.size(); ++i)
    {
      if (edge[i] != 0)
      {
        const double d = std::min(distance[i], diagonal);
        this->sum += d;
        this->most = std::max(this->most, d);
        ++this->count;
      }
    }
  }
};

void addOutline(MaskError& error, const MaskTruth& truth, const std::vector<unsigned char>& mask)
{
  const int width = truth.width();
  const int height = truth.height();
  const double diagonal = std::hypot(width, height);
  const std::vector<unsigned char> trueEdge = boundary(truth.mask(), width, height);
  const std::vector<unsigned char> maskEdge = boundary(mask, width, height);
  OutlineSum outline;
  outline.add(trueEdge, distanceTransform(maskEdge, width, height), diagonal);
  outline.add(maskEdge, distanceTransform(trueEdge, width, height), diagonal);
  error.outlineMean = outline.count > 0 ? outline.sum / static_cast<double>(outline.count) : 0.0;
  error.outlineMax = outline.most;
}

} // namespace

MaskError compareMask(const MaskTruth& truth, const std::vector<unsigned char>& mask, bool full)
{
  if (mask.size() != truth.mask().size())
  {
    throw std::invalid_argument("compareMask: the mask is not of the view's size");
  }
  MaskError error;
  error.pixels = mask.size();
  if (full)
  {
    const std::vector<unsigned char>& certain = truth.certainPixels();
    error.certain = std::accumulate(certain.begin(), certain.end(), std::size_t{0});
  }
  for (int y = 0; y < truth.height(); ++y)
  {
    for (int x = 0; x < truth.width(); ++x)
    {
      const std::size_t i = static_cast<std::size_t>(y) * truth.width() + x;
      if (reached(mask[i]) == reached(truth.mask()[i]))
      {
        continue;
      }
      ++error.wrong;
      if (full ? truth.certainPixels()[i] != 0 : truth.isCertain(x, y))
      {
        ++error.wrongCertain;
        if (error.firstWrongPixels.size() < MaskError::reportedPixels)
        {
          error.firstWrongPixels.emplace_back(x, y);
        }
      }
    }
  }
  const std::size_t of = full ? error.certain : error.pixels;
  error.wrongCertainPerMillion =
      of > 0 ? 1e6 * static_cast<double>(error.wrongCertain) / static_cast<double>(of) : 0.0;
  addOutline(error, truth, mask);
  return error;
}

} // namespace shadow::truth
