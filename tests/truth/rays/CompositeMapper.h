#pragma once

#include "../../../plugin/vtkShadowCompat.h"

#if VTKSHADOW_VTK_AT_LEAST(9, 3)
#include <vtkCompositePolyDataMapper.h>
#else
#include <vtkCompositePolyDataMapper2.h>
#endif

namespace shadow::truth
{

/// The composite mapper of this VTK that knows hidden blocks.
using CompositeMapper = VTKSHADOW_COMPOSITE_MAPPER;

} // namespace shadow::truth
