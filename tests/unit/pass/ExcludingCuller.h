#pragma once

#include <algorithm>

#include <vtkCuller.h>
#include <vtkProp.h>
#include <vtkRenderer.h>

namespace shadow::test
{

/// Has VTK leave one prop out, wherever it is, as its own cullers leave out what is too small.
class ExcludingCuller : public vtkCuller
{
public:
  static ExcludingCuller* New() { return new ExcludingCuller; }
  vtkTypeMacro(ExcludingCuller, vtkCuller);

  double Cull(vtkRenderer* /*renderer*/, vtkProp** props, int& count, int& /*initialized*/) override
  {
    count = static_cast<int>(std::remove(props, props + count, this->excluded) - props);
    return static_cast<double>(count);
  }

  vtkProp* excluded = nullptr;

protected:
  ExcludingCuller() = default;
};

} // namespace shadow::test
