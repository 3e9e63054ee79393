#pragma once

// The GL function loader that VTK itself uses: GLEW up to VTK 9.3, glad after.
#if __has_include(<vtk_glad.h>)
#include <vtk_glad.h>
#else
#include <vtk_glew.h>
#endif
