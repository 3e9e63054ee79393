# Tests of the example programs. Included by tests/unit/CMakeLists.txt; does nothing where the programs are not built.
if(TARGET shadow_examples)
  add_executable(test_examples examples/test_example_lights.cxx examples/test_output_files.cxx examples/test_render_options.cxx)
  target_link_libraries(test_examples PRIVATE shadow_examples shadow_silhouette shadow_warnings GTest::gtest_main
    VTK::CommonMath VTK::IOImage)
  gtest_discover_tests(test_examples DISCOVERY_TIMEOUT 60 PROPERTIES LABELS unit)

  if(SHADOW_TEST_PYTHON)
    foreach(part cli refusals text_files gltf ply)
      add_test(NAME shadow_render.${part} COMMAND ${SHADOW_TEST_PYTHON} -B
        ${CMAKE_CURRENT_LIST_DIR}/shadow_render_${part}.py $<TARGET_FILE:shadow_render>)
      set_tests_properties(shadow_render.${part} PROPERTIES LABELS unit TIMEOUT 600)
    endforeach()
    add_test(NAME outline_render.cli COMMAND ${SHADOW_TEST_PYTHON} -B
      ${CMAKE_CURRENT_LIST_DIR}/outline_render_cli.py $<TARGET_FILE:outline_render>)
    set_tests_properties(outline_render.cli PROPERTIES LABELS unit TIMEOUT 600)
  endif()
  add_test(NAME minimal.WritesPicture COMMAND minimal WORKING_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR})
  set_tests_properties(minimal.WritesPicture PROPERTIES LABELS unit)
endif()
