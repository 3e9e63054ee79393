# Writes _build.py, when a library of the plugin is there to ask which of VTK's it needs.
#
# cmake -DLIBRARY=... -DREADELF=... -DTEMPLATE=_build.py.in -DOUTPUT=... and what the template names
#   -P write_build.cmake
cmake_minimum_required(VERSION 3.22)
execute_process(COMMAND ${READELF} --dynamic --wide ${LIBRARY} OUTPUT_VARIABLE dynamic COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "\\(NEEDED\\)[^\n]*\\[libvtk[^]\n]*\\]" needed "${dynamic}")
if(NOT needed)
  message(FATAL_ERROR "${LIBRARY} needs no library of VTK's, says ${READELF}")
endif()
set(vtk_libraries "")
foreach(line IN LISTS needed)
  string(REGEX REPLACE ".*\\[(.*)\\].*" "\\1" name "${line}")
  string(APPEND vtk_libraries "\n    \"${name}\",")
endforeach()
string(APPEND vtk_libraries "\n")
if(VTKSHADOW_HEADLESS)
  set(has_window True)
else()
  set(has_window False)
endif()
configure_file(${TEMPLATE} ${OUTPUT} @ONLY)
