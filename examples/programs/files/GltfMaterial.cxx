#include "GltfMaterial.h"

#include <algorithm>
#include <array>

#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>

namespace shadow::examples
{
namespace
{

using Colour = std::array<double, 4>;

// Also of an array that has each component as a tuple.
std::optional<Colour> findColour(vtkDataSet* primitive)
{
  vtkDataArray* array = primitive->GetFieldData()->GetArray("BaseColorMultiplier");
  if (array == nullptr || array->GetNumberOfValues() < 3)
  {
    return std::nullopt;
  }
  Colour result = {1.0, 1.0, 1.0, 1.0};
  const int components = array->GetNumberOfComponents();
  for (int i = 0; i < std::min<int>(4, static_cast<int>(array->GetNumberOfValues())); ++i)
  {
    result[i] = std::clamp(array->GetComponent(i / components, i % components), 0.0, 1.0);
  }
  return result;
}

void setScalars(vtkDataSet* primitive, vtkDataArray* colours, const Colour& times, bool withAlpha)
{
  const int components = withAlpha && colours->GetNumberOfComponents() == 4 ? 4 : 3;
  vtkNew<vtkUnsignedCharArray> scalars;
  scalars->SetName("Colours");
  scalars->SetNumberOfComponents(components);
  scalars->SetNumberOfTuples(colours->GetNumberOfTuples());
  for (vtkIdType point = 0; point < colours->GetNumberOfTuples(); ++point)
  {
    for (int i = 0; i < components; ++i)
    {
      const double value = std::clamp(colours->GetComponent(point, i) * times[i], 0.0, 1.0);
      scalars->SetTypedComponent(point, i, static_cast<unsigned char>(255.0 * value + 0.5));
    }
  }
  primitive->GetPointData()->SetScalars(scalars);
}

} // namespace

GltfMaterial readGltfMaterial(vtkDataSet* primitive)
{
  GltfMaterial material;
  const std::optional<Colour> colour = findColour(primitive);
  vtkFieldData* fields = primitive->GetFieldData();
  vtkDataArray* cutoff = fields->GetArray("AlphaCutoff");
  const bool blends = colour && fields->GetArray("ForceOpaque") == nullptr && cutoff == nullptr;
  if (colour)
  {
    material.colour = Vector3{(*colour)[0], (*colour)[1], (*colour)[2]};
    material.opacity = blends ? (*colour)[3] : 1.0;
    material.isSeen = cutoff == nullptr || (*colour)[3] >= cutoff->GetComponent(0, 0);
  }
  vtkDataArray* colours = primitive->GetPointData()->GetArray("COLOR_0");
  if (colours != nullptr && colours->GetNumberOfComponents() >= 3)
  {
    setScalars(primitive, colours, colour.value_or(Colour{1.0, 1.0, 1.0, 1.0}), blends);
  }
  return material;
}

} // namespace shadow::examples
