#pragma once

#include <vtkSMPTools.h>

#include "ParallelFor.h"

namespace shadow
{

/// Through the threads of VTK's SMP tools, as many as the program has set.
inline ParallelFor makeSmpParallelFor()
{
  return [](std::size_t count, const std::function<void(std::size_t, std::size_t)>& part)
  {
    auto run = [&part](vtkIdType begin, vtkIdType end)
    { part(static_cast<std::size_t>(begin), static_cast<std::size_t>(end)); };
    vtkSMPTools::For(0, static_cast<vtkIdType>(count), 1, run);
  };
}

} // namespace shadow
