#include "SceneJson.h"

#include <fstream>
#include <stdexcept>

namespace shadow::fuzz
{

namespace
{

using Json = nlohmann::ordered_json;

Json fromPoint(const glm::dvec3& point)
{
  return {point.x, point.y, point.z};
}

glm::dvec3 toPoint(const Json& json)
{
  if (json.size() != 3)
  {
    throw std::runtime_error("a point needs three coordinates, not " + json.dump());
  }
  return {json.at(0).get<double>(), json.at(1).get<double>(), json.at(2).get<double>()};
}

Json fromMesh(const FuzzMesh& mesh)
{
  Json triangles = Json::array();
  for (const FuzzTriangle& triangle : mesh.triangles)
  {
    triangles.push_back({fromPoint(triangle[0]), fromPoint(triangle[1]), fromPoint(triangle[2])});
  }
  return triangles;
}

FuzzMesh toMesh(const Json& json)
{
  FuzzMesh mesh;
  for (const Json& triangle : json)
  {
    mesh.triangles.push_back({toPoint(triangle.at(0)), toPoint(triangle.at(1)), toPoint(triangle.at(2))});
  }
  return mesh;
}

/// Rows.
Json fromMatrix(const glm::dmat4& matrix)
{
  Json rows = Json::array();
  for (int row = 0; row < 4; ++row)
  {
    rows.push_back({matrix[0][row], matrix[1][row], matrix[2][row], matrix[3][row]});
  }
  return rows;
}

glm::dmat4 toMatrix(const Json& json)
{
  glm::dmat4 matrix;
  for (int row = 0; row < 4; ++row)
  {
    for (int column = 0; column < 4; ++column)
    {
      matrix[column][row] = json.at(row).at(column).get<double>();
    }
  }
  return matrix;
}

Json fromCamera(const FuzzCamera& camera)
{
  return {{"position", fromPoint(camera.position)},
          {"focalPoint", fromPoint(camera.focalPoint)},
          {"viewUp", fromPoint(camera.viewUp)},
          {"viewAngle", camera.viewAngle},
          {"parallelScale", camera.parallelScale ? Json(*camera.parallelScale) : Json(nullptr)},
          {"clippingRange", {camera.clippingRange.x, camera.clippingRange.y}}};
}

FuzzCamera toCamera(const Json& json)
{
  FuzzCamera camera;
  camera.position = toPoint(json.at("position"));
  camera.focalPoint = toPoint(json.at("focalPoint"));
  camera.viewUp = toPoint(json.at("viewUp"));
  camera.viewAngle = json.value("viewAngle", camera.viewAngle);
  if (json.contains("parallelScale") && !json.at("parallelScale").is_null())
  {
    camera.parallelScale = json.at("parallelScale").get<double>();
  }
  const Json& range = json.at("clippingRange");
  camera.clippingRange = {range.at(0).get<double>(), range.at(1).get<double>()};
  return camera;
}

Json fromLight(const FuzzLight& light)
{
  return {{"positional", light.positional},
          {"coneAngle", light.coneAngle},
          {"position", fromPoint(light.position)},
          {"focalPoint", fromPoint(light.focalPoint)}};
}

FuzzLight toLight(const Json& json)
{
  FuzzLight light;
  light.positional = json.at("positional").get<bool>();
  light.coneAngle = json.value("coneAngle", light.coneAngle);
  light.position = toPoint(json.at("position"));
  if (json.contains("focalPoint"))
  {
    light.focalPoint = toPoint(json.at("focalPoint"));
  }
  return light;
}

FuzzConfig toConfig(const Json& json)
{
  FuzzConfig config;
  config.stencil = json.value("stencil", 0);
  config.silhouette = json.value("silhouette", 0);
  config.compositing = json.value("compositing", 0);
  config.countBuffer = json.value("countBuffer", 0);
  config.alone = json.value("alone", false);
  return config;
}

void addMeshes(Json& json, const FuzzScene& scene)
{
  bool hasMatrix = false;
  Json meshes = Json::array();
  Json matrices = Json::array();
  for (const FuzzMesh& mesh : scene.meshes)
  {
    hasMatrix = hasMatrix || mesh.worldFromMC != glm::dmat4(1.0);
    meshes.push_back(fromMesh(mesh));
    matrices.push_back(fromMatrix(mesh.worldFromMC));
  }
  json["meshes"] = meshes;
  if (hasMatrix)
  {
    json["actorMatrices"] = matrices;
  }
}

} // namespace

Json toJson(const FuzzConfig& config)
{
  return {{"stencil", config.stencil},
          {"silhouette", config.silhouette},
          {"compositing", config.compositing},
          {"countBuffer", config.countBuffer},
          {"alone", config.alone}};
}

Json toJson(const FuzzScene& scene)
{
  Json json = {{"name", scene.name}, {"kind", scene.kind}, {"why", scene.why}, {"expected", scene.expected}};
  if (scene.configs.size() == 1)
  {
    json["config"] = toJson(scene.configs.front());
  }
  else if (!scene.configs.empty())
  {
    json["configs"] = Json::array();
    for (const FuzzConfig& config : scene.configs)
    {
      json["configs"].push_back(toJson(config));
    }
  }
  json["size"] = {scene.size.x, scene.size.y};
  addMeshes(json, scene);
  json["doublePoints"] = scene.doublePoints;
  json["sharedPoints"] = scene.sharedPoints;
  json["camera"] = fromCamera(scene.camera);
  json["light"] = fromLight(scene.light);
  return json;
}

FuzzScene fromJson(const Json& json)
{
  FuzzScene scene;
  scene.name = json.value("name", std::string());
  scene.kind = json.value("kind", std::string());
  scene.why = json.value("why", std::string());
  scene.expected = json.value("expected", std::string());
  scene.size = {json.at("size").at(0).get<int>(), json.at("size").at(1).get<int>()};
  for (const Json& mesh : json.at("meshes"))
  {
    scene.meshes.push_back(toMesh(mesh));
  }
  for (std::size_t i = 0; json.contains("actorMatrices") && i < scene.meshes.size(); ++i)
  {
    scene.meshes[i].worldFromMC = toMatrix(json.at("actorMatrices").at(i));
  }
  scene.doublePoints = json.value("doublePoints", false);
  scene.sharedPoints = json.value("sharedPoints", false);
  scene.camera = toCamera(json.at("camera"));
  scene.light = toLight(json.at("light"));
  if (json.contains("config"))
  {
    scene.configs.push_back(toConfig(json.at("config")));
  }
  for (const Json& config : json.value("configs", Json::array()))
  {
    scene.configs.push_back(toConfig(config));
  }
  return scene;
}

void writeScene(const FuzzScene& scene, const std::string& fileName)
{
  std::ofstream file(fileName);
  file << toJson(scene).dump(1) << '\n';
  if (!file.flush())
  {
    throw std::runtime_error("cannot write " + fileName);
  }
}

FuzzScene readScene(const std::string& fileName)
{
  std::ifstream file(fileName);
  if (!file)
  {
    throw std::runtime_error("cannot read " + fileName);
  }
  try
  {
    FuzzScene scene = fromJson(Json::parse(file));
    if (scene.name.empty())
    {
      scene.name = fileName;
    }
    return scene;
  }
  catch (const std::exception& error)
  {
    throw std::runtime_error(fileName + ": " + error.what());
  }
}

} // namespace shadow::fuzz
