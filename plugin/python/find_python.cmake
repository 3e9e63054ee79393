# Finds what wrapping needs: VTK's wrapping tools, Python's headers, and an interpreter that can `import vtkmodules`.
#
# Another python3 may stand first in PATH than the one VTK was built for. Python3_EXECUTABLE is asked first, then
# python3 in PATH, then the system's. What the headers belong to (Python3_VERSION) has been decided by find_package(VTK).
#
# Sets the cache variables VTKSHADOW_PYTHON, the interpreter, and VTKSHADOW_PYTHON_FOLDER, what the folder of its
# packages is called: dist-packages on Debian, else site-packages. @p problem gets one line when something is missing,
# or nothing.
function(find_vtk_python problem)
  set(${problem} "" PARENT_SCOPE)
  if(NOT TARGET VTK::WrapPython OR NOT TARGET VTK::WrappingPythonCore OR NOT COMMAND vtk_module_wrap_python)
    set(${problem} "this VTK has no wrapping tools (Debian: python3-vtk9)" PARENT_SCOPE)
    return()
  endif()
  if(NOT TARGET Python3::Module)
    set(${problem} "Python's headers were not found (Debian: libpython3-dev)" PARENT_SCOPE)
    return()
  endif()
  set(reasons "")
  foreach(candidate IN ITEMS "${VTKSHADOW_PYTHON}" "${Python3_EXECUTABLE}" python3 /usr/bin/python3)
    if(NOT candidate)
      continue()
    endif()
    execute_process(
      COMMAND ${candidate} -c "import os, sys, vtkmodules
print('%d.%d' % sys.version_info[:2], os.path.basename(os.path.dirname(os.path.dirname(vtkmodules.__file__))), sys.executable, sep=';')"
      RESULT_VARIABLE result OUTPUT_VARIABLE answer ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
    if(NOT result EQUAL 0)
      string(APPEND reasons ", ${candidate} cannot import vtkmodules")
      continue()
    endif()
    list(GET answer 0 version)
    if(NOT version VERSION_EQUAL "${Python3_VERSION_MAJOR}.${Python3_VERSION_MINOR}")
      string(APPEND reasons ", ${candidate} is ${version} but the headers are ${Python3_VERSION}")
      continue()
    endif()
    list(GET answer 1 folder)
    list(GET answer 2 executable)
    set(VTKSHADOW_PYTHON ${executable} CACHE FILEPATH "Interpreter that can import vtkmodules" FORCE)
    set(VTKSHADOW_PYTHON_FOLDER ${folder} CACHE INTERNAL "Name of the folder of its packages")
    return()
  endforeach()
  string(REGEX REPLACE "^, " "" reasons "${reasons}")
  set(${problem} "no interpreter fits (${reasons}); give one by Python3_EXECUTABLE" PARENT_SCOPE)
endfunction()
