#include "FuzzRun.h"

#include <algorithm>
#include <cstdio>

#include "JobLines.h"
#include "SceneJson.h"
#include "SceneMaker.h"
#include "Shrinker.h"

namespace shadow::fuzz
{

namespace
{

/// Writes the scene as small as it gets, and says where.
std::string writeCase(FuzzSession& session, const FuzzOptions& options, const FuzzScene& scene,
                      const SceneVerdict& verdict)
{
  FuzzScene small = scene;
  if (options.shrinks)
  {
    // As wrong as before, roughly, or another fault could take this one's place.
    const std::size_t found = verdict.getWorst().wrong;
    const std::size_t needed = std::max(verdict.limit + 1, std::min<std::size_t>(found / 4, 50));
    small = shrink(scene,
                   [&](const FuzzScene& smaller)
                   {
                     const SceneVerdict now = session.judge(smaller, needed);
                     return now.getFault() == verdict.getFault() &&
                            (now.getFault() != Fault::WrongMask || now.getWorst().wrong >= needed);
                   });
  }
  small.kind = getSceneKind(small);
  small.expected = "as ray casting says, which drawing did not:\n" + session.judge(small).describe();
  const std::string fileName = options.output + "/" + scene.name + ".json";
  writeScene(small, fileName);
  return "  " + std::to_string(small.getTriangleCount()) + " triangles in " + fileName + "\n";
}

/// Prints the processes that ended too early, with the scenes that they were at.
void printFailures(const FuzzOptions& options, const JobLines& jobs,
                   const std::vector<std::uint64_t>& finished)
{
  for (const JobLines::Failure& failure : jobs.getFailures())
  {
    const auto job = static_cast<std::size_t>(failure.job);
    const std::uint64_t number =
        options.first + job + finished[job] * static_cast<std::uint64_t>(options.jobs);
    std::printf("process %d %s at scene %llu\n", failure.job, failure.reason.c_str(),
                static_cast<unsigned long long>(number));
  }
}

bool report(const FuzzOptions& options, JobLines& jobs)
{
  FuzzReport report;
  std::vector<std::uint64_t> finished(static_cast<std::size_t>(options.jobs), 0);
  std::uint64_t nextProgress = options.scenes / 10;
  while (const std::optional<std::string> text = jobs.read())
  {
    const SceneLine line = toSceneLine(nlohmann::ordered_json::parse(*text));
    report.add(line);
    ++finished[static_cast<std::size_t>((line.number - options.first) %
                                        static_cast<std::uint64_t>(options.jobs))];
    std::fputs(line.text.c_str(), stdout);
    if (report.getScenes() >= nextProgress)
    {
      std::fprintf(stderr, "%llu of %llu scenes drawn, %llu wrong\n",
                   static_cast<unsigned long long>(report.getScenes()),
                   static_cast<unsigned long long>(options.scenes),
                   static_cast<unsigned long long>(report.getWrongScenes()));
      nextProgress += std::max<std::uint64_t>(options.scenes / 10, 1);
    }
    std::fflush(stdout);
  }
  printFailures(options, jobs, finished);
  report.print(stdout);
  return jobs.getFailures().empty() && report.getWrongScenes() == 0 && report.getScenes() == options.scenes;
}

} // namespace

SceneLine runScene(FuzzSession& session, const FuzzOptions& options, std::uint64_t number)
{
  FuzzScene scene = makeScene(options.seed, number);
  if (options.everyMethod)
  {
    scene.configs = listEveryConfig();
  }
  const SceneVerdict verdict = session.judge(scene);
  SceneLine line;
  line.number = number;
  line.kind = getSceneKind(scene);
  line.isWrong = verdict.isWrong();
  line.wrong = verdict.getWorst().wrong;
  line.differing = verdict.differing;
  line.wrongPerMillion = 1e6 * static_cast<double>(line.wrong) / static_cast<double>(verdict.pixels);
  if (line.isWrong || options.lists)
  {
    line.text = (line.isWrong ? "wrong: " : "right: ") + scene.name + " (" + line.kind + ", " +
                std::to_string(scene.getTriangleCount()) + " triangles)\n" + verdict.describe();
  }
  if (line.isWrong)
  {
    line.text += writeCase(session, options, scene, verdict);
  }
  return line;
}

bool runScenes(const FuzzOptions& options)
{
  JobLines jobs(options.jobs,
                [&options](int job, const JobLines::Write& write)
                {
                  FuzzSession session;
                  for (auto i = static_cast<std::uint64_t>(job); i < options.scenes;
                       i += static_cast<std::uint64_t>(options.jobs))
                  {
                    write(toJson(runScene(session, options, options.first + i)).dump());
                  }
                });
  return report(options, jobs);
}

} // namespace shadow::fuzz
