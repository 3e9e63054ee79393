#pragma once

#include <vtkVersion.h>

// VTK 9.3 merged the composite mapper with per-block display attributes into the plain one.
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
#include <vtkCompositePolyDataMapper.h>
#else
#include <vtkCompositePolyDataMapper2.h>
#endif

namespace shadow::truth
{

/// The composite mapper of this VTK that knows hidden blocks.
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
using CompositeMapper = vtkCompositePolyDataMapper;
#else
using CompositeMapper = vtkCompositePolyDataMapper2;
#endif

} // namespace shadow::truth
