#include "MaskTruth.h"

#include <numeric>

#include "ParallelRows.h"

namespace shadow::truth
{

MaskTruth::MaskTruth(const RayCaster& theCaster, const View& view, const Light& theLight)
    : caster(theCaster), rays(view, theCaster.originWC()), light(theCaster.localLight(theLight)),
      size(std::max(view.width, 0), std::max(view.height, 0)),
      values(static_cast<std::size_t>(size.x) * size.y)
{
  forEachRow(this->size.y,
             [this](int y)
             {
               unsigned char* row = this->values.data() + static_cast<std::size_t>(y) * this->size.x;
               for (int x = 0; x < this->size.x; ++x)
               {
                 row[x] = this->valueAt(x + 0.5, y + 0.5);
               }
             });
}

unsigned char MaskTruth::valueAt(double x, double y) const
{
  return this->caster.answer(this->rays.through(x, y), this->light) == Answer::Shadowed ? 0 : 255;
}

bool MaskTruth::isCertain(int x, int y) const
{
  const unsigned char value = this->values[static_cast<std::size_t>(y) * this->size.x + x];
  for (const double dx : {-certainOffset, certainOffset})
  {
    for (const double dy : {-certainOffset, certainOffset})
    {
      if (this->valueAt(x + 0.5 + dx, y + 0.5 + dy) != value)
      {
        return false;
      }
    }
  }
  return true;
}

const std::vector<unsigned char>& MaskTruth::certainPixels() const
{
  const auto compute = [this]
  {
    this->certain.resize(this->values.size());
    forEachRow(this->size.y,
               [this](int y)
               {
                 unsigned char* row = this->certain.data() + static_cast<std::size_t>(y) * this->size.x;
                 for (int x = 0; x < this->size.x; ++x)
                 {
                   row[x] = this->isCertain(x, y) ? 1 : 0;
                 }
               });
  };
  std::call_once(this->certainOnce, compute);
  return this->certain;
}

double MaskTruth::certainShare() const
{
  const std::vector<unsigned char>& pixels = this->certainPixels();
  const auto count = std::accumulate(pixels.begin(), pixels.end(), std::size_t{0});
  return pixels.empty() ? 1.0 : static_cast<double>(count) / static_cast<double>(pixels.size());
}

} // namespace shadow::truth
