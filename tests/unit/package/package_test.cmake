# One step of the package's test, run by ctest through `cmake -P`.
#
# STEP=install   installs BUILD_FOLDER into PREFIX
# STEP=consumer  configures, builds and runs the program in CONSUMER with the package in PREFIX
# STEP=readme    the same for the CMake lines of README, with the program MINIMAL as it stands
cmake_minimum_required(VERSION 3.22)

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    string(REPLACE ";" " " command "${ARGN}")
    message(FATAL_ERROR "${command}\n${output}")
  endif()
  message("${output}")
endfunction()

function(build source folder)
  file(REMOVE_RECURSE ${folder})
  run(${CMAKE_COMMAND} -S ${source} -B ${folder} -G ${GENERATOR} -DCMAKE_BUILD_TYPE=Release
    -DCMAKE_PREFIX_PATH=${PREFIX} -DVTK_DIR=${VTK_DIR} "-DCMAKE_CXX_FLAGS=${CXX_FLAGS}")
  run(${CMAKE_COMMAND} --build ${folder})
endfunction()

if(STEP STREQUAL "install")
  file(REMOVE_RECURSE ${PREFIX})
  run(${CMAKE_COMMAND} --install ${BUILD_FOLDER} --prefix ${PREFIX} --config "${CONFIG}")
elseif(STEP STREQUAL "consumer")
  build(${CONSUMER} ${SCRATCH}/consumer)
  run(${SCRATCH}/consumer/consumer)
elseif(STEP STREQUAL "readme")
  file(READ ${README} text)
  string(REGEX MATCH "```cmake\n(cmake_minimum_required[^`]*)```" found "${text}")
  if(NOT found)
    message(FATAL_ERROR "README has no CMakeLists.txt")
  endif()
  set(source ${SCRATCH}/readme)
  file(REMOVE_RECURSE ${source})
  file(WRITE ${source}/CMakeLists.txt "${CMAKE_MATCH_1}")
  file(COPY ${MINIMAL} DESTINATION ${source})
  build(${source} ${source}/build)
  run(${CMAKE_COMMAND} -E chdir ${source} build/minimal)
  if(NOT EXISTS ${source}/minimal.png)
    message(FATAL_ERROR "no minimal.png was drawn")
  endif()
else()
  message(FATAL_ERROR "no such STEP: ${STEP}")
endif()
