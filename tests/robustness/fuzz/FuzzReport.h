#pragma once

#include <cstdint>
#include <cstdio>
#include <map>
#include <string>

#include <nlohmann/json.hpp>

#include "FuzzScene.h"
#include "Judge.h"

namespace shadow::fuzz
{

/// One line on one scene, passed from the processes that draw to the one that reports.
struct SceneLine
{
  std::uint64_t number = 0;
  std::string kind; ///< see getSceneKind()
  bool isWrong = false;
  std::size_t wrong = 0;     ///< of the worst mask
  std::size_t differing = 0; ///< see SceneVerdict
  double wrongPerMillion = 0.0;
  std::string text; ///< what to print; empty: nothing
};

nlohmann::ordered_json toJson(const SceneLine& line);
SceneLine toSceneLine(const nlohmann::ordered_json& json);

/// "perspective, spot", "parallel, directional" and so on.
std::string getSceneKind(const FuzzScene& scene);

/// Adds up the scenes of a run by their kinds.
class FuzzReport
{
public:
  void add(const SceneLine& line);

  /// Kinds with their scenes, wrong scenes, and the most wrong pixels of a scene.
  void print(std::FILE* file) const;

  std::uint64_t getScenes() const { return this->total.scenes; }
  std::uint64_t getWrongScenes() const { return this->total.wrong; }

private:
  struct Row
  {
    std::uint64_t scenes = 0, wrong = 0, differing = 0;
    std::size_t mostWrong = 0;
    double mostPerMillion = 0.0;

    void add(const SceneLine& line);
    void print(std::FILE* file, const std::string& name) const;
  };

  std::map<std::string, Row> rows;
  Row total;
};

} // namespace shadow::fuzz
