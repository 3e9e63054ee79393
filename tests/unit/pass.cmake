# Tests of vtkShadowVolumePass and of the scene graph below it. Included by CMakeLists.txt.
add_executable(test_scene_graph test_scene_graph.cxx)
target_link_libraries(test_scene_graph PRIVATE
  shadow_visitors shadow_test_meshes GTest::gtest_main shadow_warnings)
gtest_discover_tests(test_scene_graph DISCOVERY_TIMEOUT 60 PROPERTIES LABELS unit)

if(VTKSHADOW_HEADLESS)
  # A scene in a headless window that the image tests use as well.
  add_library(shadow_ball_scene STATIC BallScene.cxx)
  target_include_directories(shadow_ball_scene PUBLIC ${CMAKE_CURRENT_LIST_DIR})
  target_link_libraries(shadow_ball_scene PUBLIC shadow_test_scene PRIVATE shadow_warnings)

  add_executable(test_pass
    test_gpu_silhouette.cxx
    test_pass_changes.cxx
    test_pass_growth.cxx
    test_pass_lights.cxx
    test_pass_mappers.cxx
    test_pass_materials.cxx
    test_pass_reports.cxx
    test_pass_state.cxx
    test_pass_totals.cxx
    test_pass_uses.cxx
    test_pass_windows.cxx)
  target_link_libraries(test_pass PRIVATE
    shadow_ball_scene shadow_drawable shadow_test_meshes GTest::gtest_main shadow_warnings
    VTK::CommonExecutionModel VTK::FiltersCore VTK::FiltersSources VTK::ImagingCore VTK::InteractionStyle
    VTK::RenderingFreeType VTK::RenderingVolumeOpenGL2)
  vtk_module_autoinit(TARGETS test_pass MODULES
    VTK::RenderingCore VTK::RenderingOpenGL2 VTK::RenderingFreeType VTK::RenderingVolumeOpenGL2 VTK::InteractionStyle)
  gtest_discover_tests(test_pass DISCOVERY_TIMEOUT 60 PROPERTIES LABELS unit)
endif()
