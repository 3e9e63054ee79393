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

foreach(suite_and_settings
    "HeadlessOSMesa/VTKSHADOW_HEADLESS="
    "HeadlessEGL/VTKSHADOW_HEADLESS=egl"
    "HeadlessUnknown/VTKSHADOW_HEADLESS=display"
    "HeadlessNeighbours/VTKSHADOW_HEADLESS=egl"
    "HeadlessOverride/VTKSHADOW_HEADLESS="
    "HeadlessNowhere/LD_LIBRARY_PATH=${without_gl}")
  string(REGEX MATCH "^[^/]*" suite ${suite_and_settings})
  string(REGEX REPLACE "^[^/]*/" "" setting ${suite_and_settings})
  gtest_discover_tests(test_headless TEST_FILTER ${suite}.* DISCOVERY_TIMEOUT 60
    PROPERTIES LABELS unit ENVIRONMENT ${setting})
endforeach()
