#include "FuzzReport.h"

#include <algorithm>

namespace shadow::fuzz
{

nlohmann::ordered_json toJson(const SceneLine& line)
{
  return {{"number", line.number},       {"kind", line.kind},
          {"isWrong", line.isWrong},     {"wrong", line.wrong},
          {"differing", line.differing}, {"wrongPerMillion", line.wrongPerMillion},
          {"text", line.text}};
}

SceneLine toSceneLine(const nlohmann::ordered_json& json)
{
  return {json.at("number").get<std::uint64_t>(), json.at("kind").get<std::string>(),
          json.at("isWrong").get<bool>(),         json.at("wrong").get<std::size_t>(),
          json.at("differing").get<std::size_t>(), json.at("wrongPerMillion").get<double>(),
          json.at("text").get<std::string>()};
}

std::string getSceneKind(const FuzzScene& scene)
{
  const std::string view = scene.camera.parallelScale ? "parallel" : "perspective";
  if (!scene.light.positional)
  {
    return view + ", directional";
  }
  return view + (scene.light.coneAngle < 90.0 ? ", spot" : ", point");
}

void FuzzReport::Row::add(const SceneLine& line)
{
  ++this->scenes;
  this->wrong += line.isWrong ? 1 : 0;
  this->differing += line.differing > 0 ? 1 : 0;
  this->mostWrong = std::max(this->mostWrong, line.wrong);
  this->mostPerMillion = std::max(this->mostPerMillion, line.wrongPerMillion);
}

void FuzzReport::Row::print(std::FILE* file, const std::string& name) const
{
  std::fprintf(file, "%-26s %8llu %8llu %10llu %12zu %14.1f\n", name.c_str(),
               static_cast<unsigned long long>(this->scenes), static_cast<unsigned long long>(this->wrong),
               static_cast<unsigned long long>(this->differing), this->mostWrong, this->mostPerMillion);
}

void FuzzReport::add(const SceneLine& line)
{
  this->rows[line.kind].add(line);
  this->total.add(line);
}

void FuzzReport::print(std::FILE* file) const
{
  std::fprintf(file, "%-26s %8s %8s %10s %12s %14s\n", "kind", "scenes", "wrong", "differing", "worst pixels",
               "worst per mil.");
  for (const auto& [name, row] : this->rows)
  {
    row.print(file, name);
  }
  this->total.print(file, "all");
}

} // namespace shadow::fuzz
