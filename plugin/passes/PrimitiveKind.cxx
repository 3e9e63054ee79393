#include "PrimitiveKind.h"

#include <vtkAbstractMapper.h>
#include <vtkOpenGLHelper.h>
#include <vtkOpenGLPolyDataMapper.h>

namespace shadow
{

namespace
{

// VTK tells a render pass the mapper and not the primitive, and keeps that to mappers.
struct MapperAccess : vtkOpenGLPolyDataMapper
{
  static vtkOpenGLHelper* lastBound(vtkOpenGLPolyDataMapper* mapper)
  {
    return mapper->*(&MapperAccess::LastBoundBO);
  }
  static bool isFace(int primitive) { return primitive == PrimitiveTris || primitive == PrimitiveTriStrips; }
};

} // namespace

bool drawsFaces(vtkAbstractMapper* mapper)
{
  auto* drawing = vtkOpenGLPolyDataMapper::SafeDownCast(mapper);
  const vtkOpenGLHelper* primitives = drawing != nullptr ? MapperAccess::lastBound(drawing) : nullptr;
  return primitives == nullptr || MapperAccess::isFace(primitives->PrimitiveType);
}

} // namespace shadow
