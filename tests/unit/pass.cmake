# Tests of vtkShadowVolumePass and of the scene graph below it. Included by CMakeLists.txt.
add_executable(test_scene_graph
  scene/CollectionLaws.cxx
  scene/test_scene_frame.cxx
  scene/test_scene_graph.cxx
  scene/test_screen_rectangle.cxx
  scene/test_vet_collector.cxx
  scene/test_vet_collector_changes.cxx)
target_link_libraries(test_scene_graph PRIVATE
  shadow_visitors shadow_test_meshes GTest::gtest_main shadow_warnings)
gtest_discover_tests(test_scene_graph DISCOVERY_TIMEOUT 60 PROPERTIES LABELS unit)

if(VTKSHADOW_HEADLESS)
  # A scene in a headless window that the image tests use as well.
  add_library(shadow_ball_scene STATIC pass/BallScene.cxx pass/GLInspection.cxx)
  target_include_directories(shadow_ball_scene PUBLIC pass)
  target_link_libraries(shadow_ball_scene
    PUBLIC shadow_test_scene PRIVATE shadow_drawable shadow_warnings GTest::gtest)

  add_executable(test_pass
    pass/KeptScene.cxx
    pass/VolumeCounter.cxx
    pass/test_gpu_silhouette.cxx
    pass/test_hidden_backs.cxx
    pass/test_pass_additive.cxx
    pass/test_pass_batches.cxx
    pass/test_pass_changes.cxx
    pass/test_pass_growth.cxx
    pass/test_pass_kept.cxx
    pass/test_pass_kept_elsewhere.cxx
    pass/test_pass_lights.cxx
    pass/test_pass_culled.cxx pass/test_pass_drawn.cxx
    pass/test_pass_mappers.cxx
    pass/test_pass_materials.cxx
    pass/test_pass_reports.cxx
    pass/test_pass_scissor.cxx
    pass/test_pass_state.cxx
    pass/test_pass_totals.cxx
    pass/test_pass_uses.cxx
    pass/test_pass_windows.cxx)
  target_link_libraries(test_pass PRIVATE
    shadow_ball_scene shadow_drawable shadow_test_meshes GTest::gtest_main shadow_warnings
    VTK::CommonExecutionModel VTK::FiltersCore VTK::FiltersSources VTK::ImagingCore VTK::InteractionStyle
    VTK::RenderingFreeType VTK::RenderingVolumeOpenGL2)
  vtk_module_autoinit(TARGETS test_pass MODULES
    VTK::RenderingCore VTK::RenderingOpenGL2 VTK::RenderingFreeType VTK::RenderingVolumeOpenGL2 VTK::InteractionStyle)
  gtest_discover_tests(test_pass DISCOVERY_TIMEOUT 60 PROPERTIES LABELS unit)

  add_executable(test_outline_pass
    outlines/OutlineCase.cxx
    outlines/RefusingGL.cxx
    outlines/test_large_faces.cxx
    outlines/test_outline_cases.cxx
    outlines/test_outline_copies.cxx
    outlines/test_outline_drawn.cxx
    outlines/test_outline_faces.cxx
    outlines/test_outline_pass.cxx
    outlines/test_outline_pictures.cxx
    outlines/test_outline_refusals.cxx
    outlines/test_outline_state.cxx
    outlines/test_outline_window_depth.cxx
    outlines/test_outline_windows.cxx
    outlines/test_outline_without_area.cxx)
  target_link_libraries(test_outline_pass PRIVATE
    shadow_outline_scene shadow_ball_scene shadow_effect shadow_drawable shadow_test_meshes GTest::gtest_main shadow_warnings
    VTK::FiltersHybrid $<TARGET_NAME_IF_EXISTS:VTK::FiltersHybridRendering> ${CMAKE_DL_LIBS})
  vtk_module_autoinit(TARGETS test_outline_pass MODULES VTK::RenderingCore VTK::RenderingOpenGL2)
  gtest_discover_tests(test_outline_pass DISCOVERY_TIMEOUT 60 PROPERTIES LABELS unit)

  # The groundwork of the GPU methods, without a pass. The benchmarks use the scene as well.
  add_library(shadow_gpu_scene STATIC gpu/GpuScene.cxx)
  target_include_directories(shadow_gpu_scene PUBLIC gpu)
  target_link_libraries(shadow_gpu_scene
    PUBLIC shadow_test_scene shadow_drawable shadow_visitors shadow_test_meshes PRIVATE shadow_warnings)

  add_executable(test_gpu
    gpu/test_facing_near_planes.cxx
    gpu/test_silhouette_camera.cxx
    gpu/test_silhouette_camera_precision.cxx
    gpu/test_texel_array.cxx)
  target_link_libraries(test_gpu PRIVATE
    shadow_gpu_scene shadow_silhouette_probe shadow_ball_scene GTest::gtest_main shadow_warnings VTK::FiltersCore
    VTK::IOGeometry)
  vtk_module_autoinit(TARGETS test_gpu MODULES VTK::RenderingCore VTK::RenderingOpenGL2)
  # Meshes that may be found beside the project.
  target_compile_definitions(test_gpu PRIVATE SHADOW_MODELS="${PROJECT_SOURCE_DIR}/../shared/models")
  gtest_discover_tests(test_gpu DISCOVERY_TIMEOUT 60 PROPERTIES LABELS unit)
  # Once more with the least that the GL must have, and GLSL without exact arithmetic.
  add_test(NAME SilhouetteCamera.OnGL32 COMMAND test_gpu)
  set_tests_properties(SilhouetteCamera.OnGL32 PROPERTIES LABELS unit ENVIRONMENT
    "MESA_GL_VERSION_OVERRIDE=3.2;MESA_GLSL_VERSION_OVERRIDE=150;MESA_EXTENSION_OVERRIDE=-GL_ARB_gpu_shader5")
  include(windows/headless.cmake)
  # Windows that share: headless ones by either GL, and those of a display.
  set(shared_windows windows/SharedWindows.cxx windows/SharedWindowsOperations.cxx windows/test_shared_windows.cxx)
  add_executable(test_shared_windows windows/HeadlessWindow.cxx ${shared_windows})
  target_link_libraries(test_shared_windows PRIVATE
    vtkShadow::HeadlessFirst vtkShadow::Headless vtkShadow::Passes GTest::gtest_main shadow_warnings
    VTK::FiltersSources VTK::RenderingCore VTK::RenderingOpenGL2)
  add_executable(test_shared_windows_on_display windows/DisplayWindow.cxx ${shared_windows})
  target_link_libraries(test_shared_windows_on_display PRIVATE
    vtkShadow::Passes GTest::gtest_main shadow_warnings
    VTK::FiltersSources VTK::RenderingCore VTK::RenderingOpenGL2)
  vtk_module_autoinit(TARGETS test_shared_windows test_shared_windows_on_display MODULES VTK::RenderingOpenGL2)
  gtest_discover_tests(test_shared_windows DISCOVERY_TIMEOUT 60 PROPERTIES LABELS unit)
  add_test(NAME SharedWindowsTest.OnEGL COMMAND test_shared_windows)
  # Without a display it is skipped.
  set(on_display ${CMAKE_CURRENT_LIST_DIR}/windows/on_display.sh)
  add_test(NAME SharedWindowsTest.OnDisplay COMMAND ${on_display} $<TARGET_FILE:test_shared_windows_on_display>)
  set_tests_properties(SharedWindowsTest.OnEGL SharedWindowsTest.OnDisplay PROPERTIES LABELS unit TIMEOUT 300)
  set_tests_properties(SharedWindowsTest.OnEGL PROPERTIES ENVIRONMENT VTKSHADOW_HEADLESS=egl)
  # Servers that start at the same time may take one number.
  set_tests_properties(SharedWindowsTest.OnDisplay PROPERTIES
    RESOURCE_LOCK x_server SKIP_REGULAR_EXPRESSION "there is no X server")
  # Silhouettes that the GPU keeps, read back. The benchmarks use this as well.
  add_library(shadow_silhouette_probe STATIC gpu/SilhouetteProbe.cxx silhouettes/VolumeOracle.cxx)
  target_include_directories(shadow_silhouette_probe PUBLIC gpu silhouettes)
  target_link_libraries(shadow_silhouette_probe
    PUBLIC shadow_test_scene shadow_drawable shadow_test_meshes PRIVATE shadow_warnings)

  # What is drawn, and with what on a GL that can do less.
  add_executable(test_gpu_silhouettes
    gpu/FaultyGL.cxx
    gpu/UploadCounter.cxx
    outlines/RefusingGL.cxx
    gpu/test_deforming_mesh.cxx
    gpu/test_depth_bias.cxx
    gpu/test_gpu_method_changes.cxx
    gpu/test_gpu_methods.cxx
    gpu/test_gpu_silhouettes.cxx
    gpu/test_method_check.cxx
    gpu/test_moved_buffers.cxx)
  target_link_libraries(test_gpu_silhouettes PRIVATE
    shadow_silhouette_probe shadow_ball_scene shadow_effect GTest::gtest_main shadow_warnings ${CMAKE_DL_LIBS})
  target_include_directories(test_gpu_silhouettes PRIVATE outlines silhouettes)
  vtk_module_autoinit(TARGETS test_gpu_silhouettes MODULES VTK::RenderingCore VTK::RenderingOpenGL2)
  gtest_discover_tests(test_gpu_silhouettes DISCOVERY_TIMEOUT 60 PROPERTIES LABELS unit)
  # Once more on a GL without compute shaders, and on the least there may be, bare of what it usually brings along.
  add_test(NAME GPUMethods.OnGL33 COMMAND test_gpu_silhouettes)
  add_test(NAME GPUMethods.OnGL32 COMMAND test_gpu_silhouettes)
  set_tests_properties(GPUMethods.OnGL33 GPUMethods.OnGL32 PROPERTIES
    LABELS unit TIMEOUT 300)
  set_property(TEST GPUMethods.OnGL33 PROPERTY ENVIRONMENT
    MESA_GL_VERSION_OVERRIDE=3.3 MESA_GLSL_VERSION_OVERRIDE=330)
  set_property(TEST GPUMethods.OnGL32 PROPERTY ENVIRONMENT
    MESA_GL_VERSION_OVERRIDE=3.2 MESA_GLSL_VERSION_OVERRIDE=150
    "MESA_EXTENSION_OVERRIDE=-GL_ARB_gpu_shader5 -GL_ARB_sample_shading -GL_ARB_clip_control")
  include(drop_in.cmake)
endif()
