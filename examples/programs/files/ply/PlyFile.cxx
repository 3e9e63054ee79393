#include "PlyFile.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <limits>
#include <memory>

#include "PlyHeader.h"
#include "PlyValues.h"
#include "PointRange.h"
#include "UserError.h"

namespace shadow::examples
{

namespace
{

using Columns = std::vector<std::size_t>;

// Where these properties stand in their element; nothing when one is missing.
Columns findColumns(const PlyElement& element, const std::vector<std::string>& names)
{
  Columns columns;
  for (const std::string& name : names)
  {
    columns.push_back(element.find(name));
    if (columns.back() == element.properties.size())
    {
      return {};
    }
  }
  return columns;
}

// Three or four; reals are from 0 to 1, whole numbers to 255.
class Colours
{
public:
  Colours(const PlyElement& element, const char* prefix)
  {
    const std::string before = prefix;
    this->columns = findColumns(element, {before + "red", before + "green", before + "blue"});
    if (this->columns.empty())
    {
      return;
    }
    if (element.find("alpha") < element.properties.size())
    {
      this->columns.push_back(element.find("alpha"));
    }
    for (const std::size_t column : this->columns)
    {
      this->scales.push_back(element.properties[column].type.real ? 255.0 : 1.0);
    }
    this->array->SetName("Colours");
    this->array->SetNumberOfComponents(static_cast<int>(this->columns.size()));
  }

  bool any() const { return !this->columns.empty(); }

  void add(const std::vector<double>& row)
  {
    for (std::size_t i = 0; i < this->columns.size(); ++i)
    {
      const double value = row[this->columns[i]] * this->scales[i];
      this->array->InsertNextValue(
          static_cast<unsigned char>(std::isnan(value) ? 0.0 : std::clamp(value, 0.0, 255.0) + 0.5));
    }
  }

  vtkUnsignedCharArray* get() const { return this->array; }

private:
  Columns columns;
  std::vector<double> scales;
  vtkNew<vtkUnsignedCharArray> array;
};

class PlyFile
{
public:
  vtkSmartPointer<vtkPolyData> read(const std::string& name, std::vector<std::string>& warnings)
  {
    std::ifstream stream(name, std::ios::binary);
    const PlyHeader header = readPlyHeader(stream);
    const auto size = static_cast<std::size_t>(std::filesystem::file_size(name));
    this->text = header.form == PlyHeader::Form::Text;
    this->values = openPlyValues(stream, header, size - static_cast<std::size_t>(stream.tellg()));
    for (const PlyElement& element : header.elements)
    {
      this->points += element.name == "vertex" ? element.count : 0;
    }
    for (const PlyElement& element : header.elements)
    {
      this->checkCount(element);
      this->readElement(element, warnings);
    }
    return this->mesh;
  }

private:
  // A number takes a digit and a blank, or the last one a line end that may be missing.
  std::size_t getLeast(const PlyType& type) const { return this->text ? 2 : type.size; }

  void checkCount(const PlyElement& element) const
  {
    std::size_t each = 0;
    for (const PlyProperty& property : element.properties)
    {
      each += this->getLeast(property.isList() ? property.count : property.type);
    }
    if (each > 0 && element.count > (this->values->getRest() + 1) / each)
    {
      throw UserError("line " + std::to_string(element.line) + ": the file is too short for " +
                      std::to_string(element.count) + " of the element " + element.name);
    }
  }

  std::size_t readCount(const PlyProperty& property)
  {
    const double count = this->values->next(property.count);
    if (!(count >= 0.0) || count != std::floor(count) || count > std::numeric_limits<std::uint32_t>::max())
    {
      throw UserError(this->values->getPlace() + ": a list cannot be of this length");
    }
    return static_cast<std::size_t>(count);
  }

  // @param[out] row   a value for each property, of lists their length
  // @param[out] list  the values of the property in this column
  void readRow(const PlyElement& element, std::size_t listColumn, std::vector<double>& row,
               std::vector<double>& list)
  {
    this->values->begin(element);
    for (std::size_t column = 0; column < element.properties.size(); ++column)
    {
      const PlyProperty& property = element.properties[column];
      if (!property.isList())
      {
        row[column] = this->values->next(property.type);
        continue;
      }
      const std::size_t count = this->readCount(property);
      row[column] = static_cast<double>(count);
      for (std::size_t i = 0; i < count; ++i)
      {
        const double value = this->values->next(property.type);
        if (column == listColumn)
        {
          list.push_back(value);
        }
      }
    }
  }

  void readElement(const PlyElement& element, std::vector<std::string>& warnings)
  {
    if (element.name == "vertex")
    {
      this->readPoints(element, warnings);
    }
    else if (element.name == "face" || element.name == "tristrips")
    {
      this->readFaces(element);
    }
    else
    {
      std::vector<double> row(element.properties.size());
      std::vector<double> list;
      for (std::uintmax_t i = 0; i < element.count && !row.empty(); ++i)
      {
        this->readRow(element, row.size(), row, list);
      }
    }
  }

  void readPoints(const PlyElement& element, std::vector<std::string>& warnings)
  {
    const Columns xyz = findColumns(element, {"x", "y", "z"});
    if (xyz.empty())
    {
      throw UserError("line " + std::to_string(element.line) + ": points without x, y and z");
    }
    const Columns normal = findColumns(element, {"nx", "ny", "nz"});
    const Colours plain(element, "");
    Colours colours(element, plain.any() ? "" : "diffuse_");
    vtkNew<vtkFloatArray> normals;
    normals->SetNumberOfComponents(3);
    std::vector<std::array<double, 3>> places;
    PointRange range;
    std::vector<double> row(element.properties.size());
    std::vector<double> list;
    for (std::uintmax_t i = 0; i < element.count; ++i)
    {
      this->readRow(element, row.size(), row, list);
      places.push_back({row[xyz[0]], row[xyz[1]], row[xyz[2]]});
      range.add(places.back());
      colours.add(row);
      if (!normal.empty())
      {
        normals->InsertNextTuple3(row[normal[0]], row[normal[1]], row[normal[2]]);
      }
    }
    this->setPoints(places, range.isFar());
    const bool rounded = !this->text && element.properties[xyz[0]].type.size < 8;
    const std::string warning = rounded ? range.describeStep() : std::string();
    if (!warning.empty())
    {
      warnings.push_back(warning);
    }
    this->mesh->GetPointData()->SetNormals(normal.empty() ? nullptr : normals.Get());
    this->mesh->GetPointData()->SetScalars(colours.any() ? colours.get() : nullptr);
  }

  void setPoints(const std::vector<std::array<double, 3>>& places, bool isFar)
  {
    vtkNew<vtkPoints> array;
    array->SetDataType(isFar ? VTK_DOUBLE : VTK_FLOAT);
    array->SetNumberOfPoints(static_cast<vtkIdType>(places.size()));
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      array->SetPoint(static_cast<vtkIdType>(i), places[i].data());
    }
    this->mesh->SetPoints(array);
  }

  vtkIdType checkIndex(double index) const
  {
    if (!(index >= 0.0) || index >= static_cast<double>(this->points) || index != std::floor(index))
    {
      throw UserError(this->values->getPlace() + ": a face uses a point that does not exist");
    }
    return static_cast<vtkIdType>(index);
  }

  // Strips may lie in one list, parted by -1.
  void readFaces(const PlyElement& element)
  {
    const bool strips = element.name == "tristrips";
    const std::size_t column =
        std::min(element.find("vertex_indices"), element.find("vertex_index")); // the one that is there
    if (column == element.properties.size() && element.count > 0)
    {
      throw UserError("line " + std::to_string(element.line) + ": " + element.name + " without vertex_indices");
    }
    Colours colours(element, "");
    vtkNew<vtkCellArray> cells;
    std::vector<double> row(element.properties.size());
    std::vector<double> list;
    std::vector<vtkIdType> ids;
    const auto finishCell = [&]
    {
      if (ids.size() >= 3)
      {
        cells->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
        colours.add(row);
      }
      ids.clear();
    };
    for (std::uintmax_t i = 0; i < element.count; ++i)
    {
      list.clear();
      this->readRow(element, column, row, list);
      for (const double index : list)
      {
        if (strips && index == -1.0)
        {
          finishCell();
          continue;
        }
        ids.push_back(this->checkIndex(index));
      }
      finishCell();
    }
    if (strips)
    {
      this->mesh->SetStrips(cells);
      return;
    }
    this->mesh->SetPolys(cells);
    this->mesh->GetCellData()->SetScalars(colours.any() ? colours.get() : nullptr);
  }

  bool text = true;
  std::uintmax_t points = 0;
  std::unique_ptr<PlyValues> values;
  vtkNew<vtkPolyData> mesh;
};

} // namespace

vtkSmartPointer<vtkPolyData> readPlyFile(const std::string& file, std::vector<std::string>& warnings)
{
  return PlyFile().read(file, warnings);
}

} // namespace shadow::examples
