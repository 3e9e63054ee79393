# Windows that need no display: what draws them, who makes them, and who else draws in the same process. Included by
# pass.cmake.
add_executable(test_headless
  windows/EGLNeighbour.cxx
  windows/test_headless.cxx
  windows/test_headless_neighbours.cxx
  windows/test_headless_windows.cxx
  ${PROJECT_SOURCE_DIR}/plugin/headless/EGLFunctions.cxx)
target_include_directories(test_headless PRIVATE ${PROJECT_SOURCE_DIR}/plugin/headless)
target_link_libraries(test_headless PRIVATE
  shadow_ball_scene GTest::gtest_main shadow_warnings ${CMAKE_DL_LIBS})
vtk_module_autoinit(TARGETS test_headless MODULES VTK::RenderingOpenGL2)

# A folder in which OSMesa and EGL are found first, and cannot be loaded.
set(without_gl ${CMAKE_CURRENT_BINARY_DIR}/without_gl)
foreach(library libOSMesa.so.8 libOSMesa.so.6 libOSMesa.so libEGL.so.1 libEGL.so)
  file(WRITE ${without_gl}/${library} "")
endforeach()

function(discover_headless suite setting)
  gtest_discover_tests(test_headless TEST_FILTER ${suite}.* DISCOVERY_TIMEOUT 60
    PROPERTIES LABELS unit ENVIRONMENT ${setting})
endfunction()
discover_headless(HeadlessUnset VTKSHADOW_HEADLESS=)
discover_headless(HeadlessEGL VTKSHADOW_HEADLESS=egl)
discover_headless(HeadlessUnknown VTKSHADOW_HEADLESS=display)
discover_headless(HeadlessNeighbours VTKSHADOW_HEADLESS=egl)
discover_headless(HeadlessOverride VTKSHADOW_HEADLESS=)
discover_headless(HeadlessNowhere LD_LIBRARY_PATH=${without_gl})

# What a user's script does, in the build tree, without a display.
function(add_headless_script name python script)
  add_test(NAME ${name} COMMAND ${python} -B ${CMAKE_CURRENT_SOURCE_DIR}/windows/${script} ${ARGN})
  set_tests_properties(${name} PROPERTIES LABELS unit TIMEOUT 120
    ENVIRONMENT "PYTHONPATH=${CMAKE_BINARY_DIR}/lib/python:$ENV{PYTHONPATH};DISPLAY=;WAYLAND_DISPLAY="
    SKIP_REGULAR_EXPRESSION "there is no")
endfunction()
if(VTKSHADOW_PYTHON_WRAPPED)
  foreach(backend osmesa egl unset)
    add_headless_script(HeadlessScript.Plain_${backend} ${VTKSHADOW_PYTHON} headless_plain.py ${backend})
    if(SHADOW_TEST_PYTHON)
      add_headless_script(HeadlessScript.PyVista_${backend} ${SHADOW_TEST_PYTHON} headless_pyvista.py ${backend})
    endif()
  endforeach()
endif()
