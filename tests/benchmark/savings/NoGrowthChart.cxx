// plotGrowth(), where VTK has no charts.
#include <stdexcept>

#include "CostGrowth.h"

namespace shadow::benchmarks
{

void plotGrowth(const std::vector<CostGrowth>& /*growths*/, const std::string& /*file*/)
{
  throw std::runtime_error("--plot: this VTK has no charts, or writes no SVG");
}

} // namespace shadow::benchmarks
