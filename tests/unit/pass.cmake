# Tests of vtkShadowVolumePass and of the scene graph below it. Included by CMakeLists.txt.
add_executable(test_scene_graph
  CollectionLaws.cxx
  test_scene_frame.cxx
  test_scene_graph.cxx
  test_vet_collector.cxx
  test_vet_collector_changes.cxx)
target_link_libraries(test_scene_graph PRIVATE
  shadow_visitors shadow_test_meshes GTest::gtest_main shadow_warnings)
gtest_discover_tests(test_scene_graph DISCOVERY_TIMEOUT 60 PROPERTIES LABELS unit)

if(VTKSHADOW_HEADLESS)
  # A scene in a headless window that the image tests use as well.
  add_library(shadow_ball_scene STATIC BallScene.cxx GLInspection.cxx)
  target_include_directories(shadow_ball_scene PUBLIC ${CMAKE_CURRENT_LIST_DIR})
  target_link_libraries(shadow_ball_scene
    PUBLIC shadow_test_scene PRIVATE shadow_drawable shadow_warnings GTest::gtest)

  add_executable(test_pass
    VolumeCounter.cxx
    test_gpu_silhouette.cxx
    test_hidden_backs.cxx
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

  add_executable(test_outline_pass
    OutlineCase.cxx
    RefusingGL.cxx
    test_large_faces.cxx
    test_outline_cases.cxx
    test_outline_faces.cxx
    test_outline_pass.cxx
    test_outline_refusals.cxx
    test_outline_state.cxx
    test_outline_windows.cxx
    test_outline_without_area.cxx)
  target_link_libraries(test_outline_pass PRIVATE
    shadow_outline_scene shadow_ball_scene shadow_effect shadow_drawable shadow_test_meshes GTest::gtest_main shadow_warnings
    ${CMAKE_DL_LIBS})
  vtk_module_autoinit(TARGETS test_outline_pass MODULES VTK::RenderingCore VTK::RenderingOpenGL2)
  gtest_discover_tests(test_outline_pass DISCOVERY_TIMEOUT 60 PROPERTIES LABELS unit)

  # The groundwork of the GPU methods, without a pass. The benchmarks use the scene as well.
  add_library(shadow_gpu_scene STATIC GpuScene.cxx)
  target_include_directories(shadow_gpu_scene PUBLIC ${CMAKE_CURRENT_LIST_DIR})
  target_link_libraries(shadow_gpu_scene
    PUBLIC shadow_test_scene shadow_drawable shadow_visitors shadow_test_meshes PRIVATE shadow_warnings)

  add_executable(test_gpu
    test_silhouette_camera.cxx
    test_silhouette_camera_precision.cxx
    test_texel_array.cxx)
  target_link_libraries(test_gpu PRIVATE
    shadow_gpu_scene shadow_ball_scene GTest::gtest_main shadow_warnings VTK::FiltersCore VTK::IOGeometry)
  vtk_module_autoinit(TARGETS test_gpu MODULES VTK::RenderingCore VTK::RenderingOpenGL2)
  # Meshes that may be found beside the project.
  target_compile_definitions(test_gpu PRIVATE SHADOW_MODELS="${PROJECT_SOURCE_DIR}/../shared/models")
  gtest_discover_tests(test_gpu DISCOVERY_TIMEOUT 60 PROPERTIES LABELS unit)
  # Once more with the least that the GL must have, and GLSL without exact arithmetic.
  add_test(NAME SilhouetteCamera.OnGL32 COMMAND test_gpu)
  set_tests_properties(SilhouetteCamera.OnGL32 PROPERTIES LABELS unit ENVIRONMENT
    "MESA_GL_VERSION_OVERRIDE=3.2;MESA_GLSL_VERSION_OVERRIDE=150;MESA_EXTENSION_OVERRIDE=-GL_ARB_gpu_shader5")
  add_executable(test_headless test_headless.cxx)
  target_link_libraries(test_headless PRIVATE
    shadow_ball_scene GTest::gtest_main shadow_warnings ${CMAKE_DL_LIBS})
  vtk_module_autoinit(TARGETS test_headless MODULES VTK::RenderingOpenGL2)
  foreach(suite_and_choice HeadlessOSMesa= HeadlessEGL=egl HeadlessUnknown=display)
    string(REGEX MATCH "^[^=]*" suite ${suite_and_choice})
    string(REGEX REPLACE "^[^=]*=" "" choice ${suite_and_choice})
    gtest_discover_tests(test_headless TEST_FILTER ${suite}.* DISCOVERY_TIMEOUT 60
      PROPERTIES LABELS unit ENVIRONMENT VTKSHADOW_HEADLESS=${choice})
  endforeach()
  # Silhouettes that the GPU keeps, read back. The benchmarks use this as well.
  add_library(shadow_silhouette_probe STATIC SilhouetteProbe.cxx VolumeOracle.cxx)
  target_include_directories(shadow_silhouette_probe PUBLIC ${CMAKE_CURRENT_LIST_DIR})
  target_link_libraries(shadow_silhouette_probe
    PUBLIC shadow_test_scene shadow_drawable shadow_test_meshes PRIVATE shadow_warnings)

  # What is drawn, and with what on a GL that can do less.
  add_executable(test_gpu_silhouettes
    UploadCounter.cxx
    test_deforming_mesh.cxx
    test_depth_bias.cxx
    test_gpu_method_changes.cxx
    test_gpu_methods.cxx
    test_gpu_silhouettes.cxx
    test_moved_buffers.cxx)
  target_link_libraries(test_gpu_silhouettes PRIVATE
    shadow_silhouette_probe shadow_ball_scene GTest::gtest_main shadow_warnings)
  vtk_module_autoinit(TARGETS test_gpu_silhouettes MODULES VTK::RenderingCore VTK::RenderingOpenGL2)
  gtest_discover_tests(test_gpu_silhouettes DISCOVERY_TIMEOUT 60 PROPERTIES LABELS unit)
  # Once more on a GL without compute shaders, and on the least there may be, bare of what it usually brings along.
  add_test(NAME GPUMethods.OnGL33 COMMAND test_gpu_silhouettes)
  add_test(NAME GPUMethods.OnGL32 COMMAND test_gpu_silhouettes)
  # And on one that says it can, and then does not.
  add_test(NAME GPUMethods.BrokenCompute COMMAND test_gpu_silhouettes --gtest_filter=GPUMethods.*)
  set_tests_properties(GPUMethods.OnGL33 GPUMethods.OnGL32 GPUMethods.BrokenCompute PROPERTIES
    LABELS unit TIMEOUT 300)
  set_property(TEST GPUMethods.BrokenCompute PROPERTY ENVIRONMENT
    MESA_GL_VERSION_OVERRIDE=4.3 MESA_GLSL_VERSION_OVERRIDE=420 SHADOW_TEST_BROKEN_COMPUTE=1)
  set_property(TEST GPUMethods.OnGL33 PROPERTY ENVIRONMENT
    MESA_GL_VERSION_OVERRIDE=3.3 MESA_GLSL_VERSION_OVERRIDE=330)
  set_property(TEST GPUMethods.OnGL32 PROPERTY ENVIRONMENT
    MESA_GL_VERSION_OVERRIDE=3.2 MESA_GLSL_VERSION_OVERRIDE=150
    "MESA_EXTENSION_OVERRIDE=-GL_ARB_gpu_shader5 -GL_ARB_sample_shading -GL_ARB_clip_control")
endif()
