#include "ModelReader.h"

#include "GltfCopy.h"
#include "GltfMaterial.h"
#include "MemoryCap.h"
#include "MeshCheck.h"
#include "ObjCopy.h"
#include "PlyFile.h"
#include "ReaderGuard.h"
#include "StlFile.h"
#include "TextCheck.h"
#include "UserError.h"
#include "VtkMessages.h"

#include <vtkCompositeDataIterator.h>
#include <vtkDataSet.h>
#include <vtkFieldData.h>
#include <vtkGLTFReader.h>
#include <vtkGenericDataObjectReader.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkOBJReader.h>
#include <vtkPointSet.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSTLReader.h>
#include <vtkXMLPolyDataReader.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>

#include <unistd.h>

namespace shadow::examples
{
namespace
{

const std::string DAMAGED = "the file is damaged";

// A data set as its reader left it.
struct RawPart
{
  vtkSmartPointer<vtkDataSet> data;
  std::optional<Vector3> colour;
  double opacity = 1.0;
};

using ReadFunction = std::function<std::vector<RawPart>(const std::string&, std::vector<std::string>&)>;

template <typename Reader>
std::vector<RawPart> readWith(const std::string& file, std::vector<std::string>& /*warnings*/)
{
  vtkNew<Reader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  const vtkSmartPointer<vtkDataSet> data = vtkDataSet::SafeDownCast(reader->GetOutputDataObject(0));
  std::vector<RawPart> parts;
  if (data != nullptr)
  {
    parts.push_back({data, std::nullopt, 1.0});
  }
  return parts;
}

// Points in double precision, moved by what they are relative to.
void movePoints(vtkDataSet* data, const std::array<double, 3>& by)
{
  auto* pointSet = vtkPointSet::SafeDownCast(data);
  if (pointSet == nullptr || pointSet->GetPoints() == nullptr)
  {
    return;
  }
  vtkNew<vtkPoints> moved;
  moved->SetDataTypeToDouble();
  moved->SetNumberOfPoints(pointSet->GetNumberOfPoints());
  for (vtkIdType point = 0; point < pointSet->GetNumberOfPoints(); ++point)
  {
    std::array<double, 3> at{};
    pointSet->GetPoint(point, at.data());
    moved->SetPoint(point, at[0] + by[0], at[1] + by[1], at[2] + by[2]);
  }
  pointSet->SetPoints(moved);
}

void moveParts(const std::vector<RawPart>& parts, const std::array<double, 3>& by)
{
  for (const RawPart& part : parts)
  {
    if (by != std::array<double, 3>{0.0, 0.0, 0.0})
    {
      movePoints(part.data, by);
    }
  }
}

std::vector<RawPart> readStl(const std::string& file, std::vector<std::string>& warnings)
{
  const StlFindings findings = checkStl(file, warnings);
  std::vector<RawPart> parts =
      readWith<vtkSTLReader>(findings.copy != nullptr ? findings.copy->getName() : file, warnings);
  moveParts(parts, findings.shift);
  return parts;
}

std::vector<RawPart> readPly(const std::string& file, std::vector<std::string>& warnings)
{
  return {{readPlyFile(file, warnings), std::nullopt, 1.0}};
}

std::vector<RawPart> readObj(const std::string& file, std::vector<std::string>& warnings)
{
  const ObjFindings findings = checkObj(file);
  if (!findings.damage.empty())
  {
    throw UserError(findings.damage);
  }
  const bool isFar = findings.shift != std::array<double, 3>{0.0, 0.0, 0.0};
  if (!findings.unusual && !isFar)
  {
    return readWith<vtkOBJReader>(file, warnings);
  }
  const ObjCopy copy(file, findings.shift);
  std::vector<RawPart> parts = readWith<vtkOBJReader>(copy.getName(), warnings);
  moveParts(parts, findings.shift);
  return parts;
}

std::vector<RawPart> readGltf(const std::string& file, std::vector<std::string>& warnings)
{
  const GltfCopy copy(file, warnings);
  vtkNew<vtkGLTFReader> reader;
  reader->SetFileName(copy.getName().c_str());
  reader->ApplyDeformationsToGeometryOn(); // the nodes' transforms, too
  reader->Update();
  std::vector<RawPart> parts;
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(reader->GetOutputDataObject(0));
  if (blocks == nullptr)
  {
    return parts;
  }
  bool translucent = false;
  const auto iterator = vtk::TakeSmartPointer(blocks->NewIterator());
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    if (auto* data = vtkDataSet::SafeDownCast(iterator->GetCurrentDataObject()))
    {
      const GltfMaterial material = readGltfMaterial(data);
      translucent = translucent || material.opacity < 1.0;
      if (material.isSeen)
      {
        parts.push_back({data, material.colour, material.opacity});
      }
    }
  }
  if (translucent)
  {
    warnings.emplace_back("what is translucent in it (alphaMode BLEND) casts no shadow");
  }
  return parts;
}

const std::map<std::string, ReadFunction>& readers()
{
  static const std::map<std::string, ReadFunction> table = {
      {"obj", readObj},
      {"ply", readPly},
      {"stl", readStl},
      {"vtp", readWith<vtkXMLPolyDataReader>},
      {"vtk", readWith<vtkGenericDataObjectReader>},
      {"gltf", readGltf},
      {"glb", readGltf},
  };
  return table;
}

const ReadFunction& findReader(const std::string& file)
{
  std::string extension = std::filesystem::path(file).extension().string();
  extension.erase(0, 1);
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const auto found = readers().find(extension);
  if (found == readers().end())
  {
    throw UserError("unknown kind of model; known: obj, ply, stl, vtp, vtk, gltf, glb");
  }
  return found->second;
}

void checkFile(const std::string& file)
{
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(file, error);
  if (!std::filesystem::exists(status))
  {
    throw UserError("no such file");
  }
  if (!std::filesystem::is_regular_file(status))
  {
    throw UserError("is not a file");
  }
  if (access(file.c_str(), R_OK) != 0)
  {
    throw UserError("may not be read");
  }
  if (std::filesystem::file_size(file, error) == 0)
  {
    throw UserError("is empty");
  }
}

// Some readers only warn of a file that stops too early.
bool isFatal(const std::string& warning)
{
  return warning.find("rror") != std::string::npos || warning.find("EOF") != std::string::npos;
}

// The pipeline adds that an algorithm failed, which says less than what the algorithm itself said before.
bool isFromPipeline(const std::string& error)
{
  return error.rfind("Algorithm ", 0) == 0;
}

void checkMessages(const VtkMessages& messages, std::vector<std::string>& warnings)
{
  std::vector<std::string> causes = messages.errors();
  causes.erase(std::remove_if(causes.begin(), causes.end(), isFromPipeline), causes.end());
  const bool failed = !messages.errors().empty();
  for (const std::string& warning : messages.warnings())
  {
    (failed || isFatal(warning) ? causes : warnings).push_back(warning);
  }
  if (failed || !causes.empty())
  {
    throw UserError("cannot be read: " + (causes.empty() ? DAMAGED : causes.front()));
  }
}

Model readChecked(const std::string& file, std::vector<std::string>& warnings)
{
  const ReadFunction& read = findReader(file);
  checkFile(file);
  VtkMessages messages;
  std::vector<RawPart> rawParts;
  {
    const MemoryCap cap(std::filesystem::file_size(file));
    rawParts = read(file, warnings);
  }
  checkMessages(messages, warnings);

  Model model;
  model.file = file;
  bool area = false;
  for (const RawPart& raw : rawParts)
  {
    const std::string damage = findDamage(raw.data);
    if (!damage.empty())
    {
      throw UserError(damage);
    }
    ModelPart part = {extractTriangles(raw.data), raw.colour, raw.opacity};
    if (part.surface->GetNumberOfPolys() > 0)
    {
      area = area || hasArea(part.surface);
      model.triangles += part.surface->GetNumberOfPolys();
      model.parts.push_back(std::move(part));
    }
  }
  messages.clear(); // of the filters: what they drop is counted here
  if (model.triangles == 0)
  {
    throw UserError("holds no triangles");
  }
  if (!area)
  {
    throw UserError("holds no triangle that has an area");
  }
  return model;
}

} // namespace

Model readModel(const std::string& file, const std::string& program, std::vector<std::string>& warnings)
{
  const ReaderGuard guard(program + ": " + file + ": cannot be read: " + DAMAGED);
  try
  {
    return readChecked(file, warnings);
  }
  catch (const UserError& error)
  {
    throw UserError(file + ": " + error.what());
  }
  catch (const std::bad_alloc&)
  {
    throw UserError(file + ": does not fit into memory");
  }
  catch (const std::exception&)
  {
    throw UserError(file + ": cannot be read: " + DAMAGED); // a length or an index that a container refused
  }
}

} // namespace shadow::examples
