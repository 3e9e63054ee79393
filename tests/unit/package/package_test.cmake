# One step of the package's test, run by ctest through `cmake -P`.
#
# STEP=install   installs BUILD_FOLDER into PREFIX
# STEP=consumer  configures, builds and runs the program in CONSUMER with the package in PREFIX
cmake_minimum_required(VERSION 3.22)

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    string(REPLACE ";" " " command "${ARGN}")
    message(FATAL_ERROR "${command}\n${output}")
  endif()
  message("${output}")
endfunction()

if(STEP STREQUAL "install")
  file(REMOVE_RECURSE ${PREFIX})
  run(${CMAKE_COMMAND} --install ${BUILD_FOLDER} --prefix ${PREFIX} --config "${CONFIG}")
elseif(STEP STREQUAL "consumer")
  set(build ${SCRATCH}/consumer)
  file(REMOVE_RECURSE ${build})
  run(${CMAKE_COMMAND} -S ${CONSUMER} -B ${build} -G ${GENERATOR} -DCMAKE_BUILD_TYPE=Release
    -DCMAKE_PREFIX_PATH=${PREFIX} -DVTK_DIR=${VTK_DIR} "-DCMAKE_CXX_FLAGS=${CXX_FLAGS}")
  run(${CMAKE_COMMAND} --build ${build})
  run(${build}/consumer)
else()
  message(FATAL_ERROR "no such STEP: ${STEP}")
endif()
