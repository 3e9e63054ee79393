#ifndef vtkShadowCompat_h
#define vtkShadowCompat_h

// Everything that differs between VTK 9.1 and 9.7, in one place. The GL function loader is in
// nodes/drawable/gl/OpenGL.h.

#include <vtkVersionMacros.h>

#define VTKSHADOW_VTK_AT_LEAST(major, minor)                                                                 \
  (VTK_MAJOR_VERSION > (major) || (VTK_MAJOR_VERSION == (major) && VTK_MINOR_VERSION >= (minor)))

// 9.3 gave the mapper with block attributes the name of the one without.
#if VTKSHADOW_VTK_AT_LEAST(9, 3)
#define VTKSHADOW_COMPOSITE_MAPPER vtkCompositePolyDataMapper
#else
#define VTKSHADOW_COMPOSITE_MAPPER vtkCompositePolyDataMapper2
#endif

// 9.7 keeps a renderer's props in a vector instead of an array.
#define VTKSHADOW_PROPS_ARE_A_VECTOR VTKSHADOW_VTK_AT_LEAST(9, 7)

// 9.6 has the types of an unstructured grid's cells in an array of any type.
#if VTKSHADOW_VTK_AT_LEAST(9, 6)
#define VTKSHADOW_CELL_TYPES(grid) (grid)->GetCellTypes()
#else
#define VTKSHADOW_CELL_TYPES(grid) (grid)->GetCellTypesArray()
#endif

// PyVista's build (cvista) has no actors with levels of detail, splats as spheres, and half of the filters among passes.
#if __has_include(<vtkOutlineGlowPass.h>)
#define VTKSHADOW_VTK_IS_WHOLE 1
#else
#define VTKSHADOW_VTK_IS_WHOLE 0
#endif

// 9.4 loads GL functions through glad, and lets a window say how.
#define VTKSHADOW_WINDOW_LOADS_SYMBOLS VTKSHADOW_VTK_AT_LEAST(9, 4)

// 9.4 chooses its windows when the program runs, and without a display one that needs none: through EGL, else by OSMesa.
#define VTKSHADOW_VTK_DRAWS_HEADLESS VTKSHADOW_VTK_AT_LEAST(9, 4)

#endif
