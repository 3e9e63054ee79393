// Changes random scenes again and again, and holds what a pass that has seen it all draws against what others
// do that keep nothing. Ends with 1 when they differ, or when the pass never kept anything.
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include <CLI/CLI.hpp>

#include "ChangeSequence.h"

int main(int argc, char** argv)
{
  CLI::App app{"Random changes of random scenes, drawn by a pass that keeps what it can and by new ones.",
               "fuzz_changes"};
  std::uint64_t sequences = 100;
  std::uint64_t seed = 1;
  std::uint64_t first = 0;
  int changes = 100;
  app.add_option("--sequences", sequences, "How many scenes")->capture_default_str();
  app.add_option("--changes", changes, "How many changes of each")->capture_default_str();
  app.add_option("--seed", seed, "Another seed, other sequences")->capture_default_str();
  app.add_option("--first", first, "Number of the first sequence")->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  shadow::fuzz::SequenceResult sum;
  std::uint64_t wrong = 0;
  for (std::uint64_t i = first; i < first + sequences; ++i)
  {
    const shadow::fuzz::SequenceResult result = shadow::fuzz::runSequence(seed, i, changes);
    sum.changes += result.changes;
    sum.checks += result.checks;
    sum.lights += result.lights;
    sum.keptLights += result.keptLights;
    if (!result.fault.empty())
    {
      ++wrong;
      std::printf("wrong: sequence %llu, %s", static_cast<unsigned long long>(i), result.fault.c_str());
      std::fflush(stdout);
    }
  }
  std::printf("%llu of %llu sequences wrong; %d changes, %d checks; %d of %d lights kept\n",
              static_cast<unsigned long long>(wrong), static_cast<unsigned long long>(sequences), sum.changes,
              sum.checks, sum.keptLights, sum.lights);
  return wrong == 0 && sum.keptLights > 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
