#ifndef vtkShadowCompat_h
#define vtkShadowCompat_h

// Everything that differs between VTK 9.1 and 9.6, in one place.

#include <vtkActor.h>
#include <vtkCompositeDataDisplayAttributes.h>
#include <vtkMapper.h>
#include <vtkVersionMacros.h>

#if VTK_VERSION_NUMBER >= 90300000000ULL || (VTK_MAJOR_VERSION == 9 && VTK_MINOR_VERSION >= 3)
#include <vtkCompositePolyDataMapper.h>
using vtkShadowCompositeMapper = vtkCompositePolyDataMapper;
#else
#include <vtkCompositePolyDataMapper2.h>
using vtkShadowCompositeMapper = vtkCompositePolyDataMapper2;
#endif

#endif
