# The package as others get it: installed into a folder of its own, used from outside. Included by CMakeLists.txt.
set(package_prefix ${CMAKE_CURRENT_BINARY_DIR}/package/prefix)
set(package_test ${CMAKE_COMMAND} -DBUILD_FOLDER=${PROJECT_BINARY_DIR} -DPREFIX=${package_prefix}
  -DSCRATCH=${CMAKE_CURRENT_BINARY_DIR}/package -DGENERATOR=${CMAKE_GENERATOR} -DCONFIG=$<CONFIG>)

add_test(NAME package.Installs
  COMMAND ${package_test} -DSTEP=install -P ${CMAKE_CURRENT_LIST_DIR}/package_test.cmake)
set_tests_properties(package.Installs PROPERTIES LABELS unit FIXTURES_SETUP package TIMEOUT 120)

if(VTKSHADOW_HEADLESS)
  set(outside -DVTK_DIR=${VTK_DIR} -DCXX_FLAGS=${CMAKE_CXX_FLAGS} -P ${CMAKE_CURRENT_LIST_DIR}/package_test.cmake)
  add_test(NAME package.OutsideProgram_FindsAndRenders
    COMMAND ${package_test} -DSTEP=consumer -DCONSUMER=${CMAKE_CURRENT_LIST_DIR}/consumer ${outside})
  add_test(NAME package.ReadmesCMakeLines_BuildMinimal
    COMMAND ${package_test} -DSTEP=readme -DREADME=${PROJECT_SOURCE_DIR}/README.md
      -DMINIMAL=${PROJECT_SOURCE_DIR}/examples/minimal.cxx ${outside})
  set_tests_properties(package.OutsideProgram_FindsAndRenders package.ReadmesCMakeLines_BuildMinimal PROPERTIES
    LABELS unit FIXTURES_REQUIRED package TIMEOUT 300)
endif()

if(VTKSHADOW_HEADLESS AND VTKSHADOW_PYTHON_WRAPPED)
  foreach(case renders_by_osmesa renders_by_egl renders_by_what_there_is vtk_first no_osmesa no_egl nothing_chosen
      nothing_chosen_no_osmesa nothing_draws_beside_a_display unknown_backend without_headless)
    add_test(NAME package.Python_${case}
      COMMAND ${VTKSHADOW_PYTHON} -B ${CMAKE_CURRENT_LIST_DIR}/python_import.py ${case})
    set_tests_properties(package.Python_${case} PROPERTIES
      LABELS unit FIXTURES_REQUIRED package TIMEOUT 120 SKIP_REGULAR_EXPRESSION "^SKIPPED"
      ENVIRONMENT "PYTHONPATH=${package_prefix}/${VTKSHADOW_PYTHON_DESTINATION};DISPLAY=;WAYLAND_DISPLAY=")
  endforeach()
endif()

if(VTKSHADOW_PYTHON_WRAPPED)
  foreach(test vtk stubs)
    add_test(NAME package.PythonPackage_${test}
      COMMAND ${VTKSHADOW_PYTHON} -B ${CMAKE_CURRENT_LIST_DIR}/python_${test}.py)
    set_tests_properties(package.PythonPackage_${test} PROPERTIES
      LABELS unit FIXTURES_REQUIRED package TIMEOUT 120
      ENVIRONMENT "PYTHONPATH=${package_prefix}/${VTKSHADOW_PYTHON_DESTINATION}")
  endforeach()
endif()
