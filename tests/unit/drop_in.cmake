# Scenes that must look the same with our passes as without, where these have nothing to add. Included by
# pass.cmake.
find_package(VTK 9.1 REQUIRED COMPONENTS ChartsCore InteractionWidgets RenderingContextOpenGL2 RenderingFreeType
  RenderingLabel OPTIONAL_COMPONENTS RenderingLOD)
add_executable(test_drop_in
  drop_in/DropInCase.cxx
  drop_in/DropInScene.cxx
  drop_in/KnownDifferences.cxx
  drop_in/OverlayRows.cxx
  drop_in/PassRows.cxx
  drop_in/PropRows.cxx
  drop_in/SettingRows.cxx
  drop_in/SurfaceRows.cxx
  drop_in/TranslucentRows.cxx
  drop_in/WindowRows.cxx
  drop_in/test_drop_in.cxx)
target_link_libraries(test_drop_in PRIVATE
  shadow_ball_scene GTest::gtest_main shadow_warnings
  VTK::ChartsCore VTK::FiltersCore VTK::FiltersSources VTK::InteractionStyle VTK::InteractionWidgets
  VTK::RenderingAnnotation VTK::RenderingContextOpenGL2 VTK::RenderingFreeType VTK::RenderingLabel
  $<TARGET_NAME_IF_EXISTS:VTK::RenderingLOD> VTK::RenderingVolumeOpenGL2)
vtk_module_autoinit(TARGETS test_drop_in MODULES
  VTK::RenderingCore VTK::RenderingOpenGL2 VTK::RenderingContextOpenGL2 VTK::RenderingFreeType
  VTK::RenderingVolumeOpenGL2 VTK::InteractionStyle)
gtest_discover_tests(test_drop_in DISCOVERY_TIMEOUT 60 NO_PRETTY_VALUES PROPERTIES LABELS unit)

# The same as PyVista's users meet it, where there is PyVista: on a server of its own, else on the user's display.
if(SHADOW_TEST_PYTHON AND VTKSHADOW_PYTHON_WRAPPED)
  add_test(NAME DropInPyVista COMMAND ${on_display} ${SHADOW_TEST_PYTHON} -B
    ${CMAKE_CURRENT_SOURCE_DIR}/drop_in/drop_in_pyvista.py)
  set_tests_properties(DropInPyVista PROPERTIES LABELS unit TIMEOUT 300 RESOURCE_LOCK x_server
    ENVIRONMENT "PYTHONPATH=${CMAKE_BINARY_DIR}/lib/python:$ENV{PYTHONPATH}"
    SKIP_REGULAR_EXPRESSION "there is no PyVista")

  # plotter.exact_shadows, and where pyvista-render-passes is (Python 3.12 and PyVista 0.49) the provider for it.
  foreach(part component chains render_passes)
    add_test(NAME PyVista.${part} COMMAND ${on_display} ${SHADOW_TEST_PYTHON} -B
      ${CMAKE_CURRENT_SOURCE_DIR}/with_pyvista/test_${part}.py)
    set_tests_properties(PyVista.${part} PROPERTIES LABELS unit TIMEOUT 900 RESOURCE_LOCK x_server
      ENVIRONMENT "PYTHONPATH=${CMAKE_BINARY_DIR}/lib/python:$ENV{PYTHONPATH}"
      SKIP_REGULAR_EXPRESSION "there is no PyVista;there is no pyvista-render-passes")
  endforeach()
  include(with_pyvista/gallery.cmake)
endif()
