#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "FuzzScene.h"

namespace shadow::fuzz
{

/// A scene as text and back, every number to its last digit.
///
/// Required: "meshes" (a list of triangles for every actor, world space), "camera", "light", "size".
/// Optional: "actorMatrices" (rows; world from model space), "doublePoints", "sharedPoints", "config" (one
/// way to draw it) or "configs" (several), "name", "kind", "why", "expected".
nlohmann::ordered_json toJson(const FuzzScene& scene);

/// @throws std::exception  with what is missing or wrong
FuzzScene fromJson(const nlohmann::ordered_json& json);

/// @throws std::runtime_error  with the file's name
void writeScene(const FuzzScene& scene, const std::string& fileName);
FuzzScene readScene(const std::string& fileName);

nlohmann::ordered_json toJson(const FuzzConfig& config);

} // namespace shadow::fuzz
