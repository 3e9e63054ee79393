#include "DistanceTransform.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace shadow::truth
{

namespace
{

constexpr double infinite = std::numeric_limits<double>::infinity();

/// The lower envelope of parabolas along one line, reused from line to line.
class LineTransform
{
public:
  explicit LineTransform(int longest) : vertices(longest), starts(longest), results(longest) {}

  /// Replaces the squared distances along a line by their minimum over the line plus the squared way there.
  void apply(double* line, int count, int stride)
  {
    const int parabolas = this->envelope(line, count, stride);
    if (parabolas == 0)
    {
      return;
    }
    int k = 0;
    for (int i = 0; i < count; ++i)
    {
      while (k + 1 < parabolas && this->starts[k + 1] < i)
      {
        ++k;
      }
      const double way = i - this->vertices[k];
      this->results[i] = way * way + line[this->vertices[k] * stride];
    }
    for (int i = 0; i < count; ++i)
    {
      line[i * stride] = this->results[i];
    }
  }

private:
  /// Which parabolas are lowest somewhere, and from where on; their number is returned.
  int envelope(const double* line, int count, int stride)
  {
    int parabolas = 0;
    for (int i = 0; i < count; ++i)
    {
      const double height = line[i * stride];
      if (height == infinite)
      {
        continue;
      }
      double start = -infinite;
      while (parabolas > 0)
      {
        const double j = this->vertices[parabolas - 1];
        const double other = line[this->vertices[parabolas - 1] * stride];
        start = ((height + static_cast<double>(i) * i) - (other + j * j)) / (2.0 * (i - j));
        if (start > this->starts[parabolas - 1])
        {
          break;
        }
        --parabolas;
      }
      this->vertices[parabolas] = i;
      this->starts[parabolas] = parabolas == 0 ? -infinite : start;
      ++parabolas;
    }
    return parabolas;
  }

  std::vector<int> vertices;
  std::vector<double> starts, results;
};

} // namespace

std::vector<double> distanceTransform(const std::vector<unsigned char>& set, int width, int height)
{
  std::vector<double> distances(set.size());
  std::transform(set.begin(), set.end(), distances.begin(),
                 [](unsigned char value) { return value != 0 ? 0.0 : infinite; });
  LineTransform line(std::max({width, height, 1}));
  for (int x = 0; x < width; ++x)
  {
    line.apply(distances.data() + x, height, width);
  }
  for (int y = 0; y < height; ++y)
  {
    line.apply(distances.data() + static_cast<std::size_t>(y) * width, width, 1);
  }
  std::transform(distances.begin(), distances.end(), distances.begin(),
                 [](double squared) { return std::sqrt(squared); });
  return distances;
}

} // namespace shadow::truth
