# Finds what wrapping needs: VTK's wrapping tools, Python's headers, and an interpreter that can import VTK's package.
#
# Another python3 may stand first in PATH than the one VTK was built for. Python3_EXECUTABLE is asked first, then
# python3 in PATH, then the system's. What the headers belong to (Python3_VERSION) has been decided by
# find_package(VTK). The interpreter's VTK must be the one of the headers: classes of another version, or of another
# package with the same version, have other sizes.
#
# Sets the cache variables VTKSHADOW_PYTHON, the interpreter, VTKSHADOW_PYTHON_FOLDER, what the folder of its packages
# is called: dist-packages on Debian, else site-packages, and VTKSHADOW_VTK_DISTRIBUTION, what pip calls VTK's
# version, or nothing. @p problem gets one line when something is missing, or nothing.
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
    execute_process(COMMAND ${candidate} ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/ask_python.py ${VTKSHADOW_VTK_PACKAGE}
      RESULT_VARIABLE result OUTPUT_VARIABLE answer ERROR_VARIABLE error
      OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_STRIP_TRAILING_WHITESPACE)
    if(NOT result EQUAL 0)
      string(REGEX REPLACE ".*\n" "" error "${error}")
      string(APPEND reasons ", ${candidate} ${error}")
      continue()
    endif()
    list(GET answer 0 version)
    list(GET answer 3 vtk_version)
    if(NOT version VERSION_EQUAL "${Python3_VERSION_MAJOR}.${Python3_VERSION_MINOR}")
      string(APPEND reasons ", ${candidate} is ${version} but the headers are ${Python3_VERSION}")
      continue()
    endif()
    if(NOT vtk_version VERSION_EQUAL VTK_VERSION)
      string(APPEND reasons
        ", ${candidate} has ${VTKSHADOW_VTK_PACKAGE} ${vtk_version} but the headers are ${VTK_VERSION}")
      continue()
    endif()
    list(GET answer 1 folder)
    list(GET answer 2 executable)
    list(GET answer 4 distribution)
    set(VTKSHADOW_PYTHON ${executable} CACHE FILEPATH "Interpreter that can import VTK" FORCE)
    set(VTKSHADOW_PYTHON_FOLDER ${folder} CACHE INTERNAL "Name of the folder of its packages")
    set(VTKSHADOW_VTK_DISTRIBUTION "${distribution}" CACHE INTERNAL "What pip calls its VTK's version")
    return()
  endforeach()
  string(REGEX REPLACE "^, " "" reasons "${reasons}")
  string(CONCAT line "the headers are of ${VTKSHADOW_VTK_PACKAGE} ${VTK_VERSION}, another VTK has classes of other "
    "sizes, and no interpreter fits (${reasons}); give one by Python3_EXECUTABLE")
  set(${problem} "${line}" PARENT_SCOPE)
endfunction()
