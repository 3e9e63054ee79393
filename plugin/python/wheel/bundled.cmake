# OpenMesh and GLM for a wheel, in place of find_package: targets of the same names, from the archives in sources.txt.
#
# pip fetches them into VTKSHADOW_SOURCES, unless they are there. Their sums are compared in either case. Of OpenMesh the connectivity alone is needed.
set(VTKSHADOW_SOURCES ${PROJECT_BINARY_DIR}/sources CACHE PATH "Folder of the archives that a wheel has built in")
find_package(Python3 REQUIRED COMPONENTS Interpreter)

file(GLOB archives ${VTKSHADOW_SOURCES}/*.tar.gz)
if(NOT archives)
  # None of their scripts is needed, but pip asks each archive for its name.
  execute_process(
    COMMAND ${Python3_EXECUTABLE} -m pip --disable-pip-version-check download --quiet --no-deps --no-binary :all:
      --require-hashes --requirement ${CMAKE_CURRENT_LIST_DIR}/sources.txt --dest ${VTKSHADOW_SOURCES}
    RESULT_VARIABLE result)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "pip could not fetch ${CMAKE_CURRENT_LIST_DIR}/sources.txt; put the archives into "
      "VTKSHADOW_SOURCES=${VTKSHADOW_SOURCES}")
  endif()
endif()

# Unpacks what is in @p folder of the archive @p name; @p result is where it lies then.
function(unpack_source name folder result)
  set(unpacked ${PROJECT_BINARY_DIR}/unpacked)
  file(GLOB archive ${VTKSHADOW_SOURCES}/${name}-*.tar.gz)
  if(NOT archive)
    message(FATAL_ERROR "The archive of ${name} is not in VTKSHADOW_SOURCES=${VTKSHADOW_SOURCES}")
  endif()
  file(STRINGS ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/sources.txt reviewed REGEX "^${name}==.*--hash=sha256:")
  file(SHA256 "${archive}" sum)
  if(NOT reviewed MATCHES "--hash=sha256:${sum}")
    message(FATAL_ERROR "${archive} is not the archive of sources.txt (${reviewed}): its sum is ${sum}")
  endif()
  file(ARCHIVE_EXTRACT INPUT ${archive} DESTINATION ${unpacked} PATTERNS "${name}-*/${folder}/*")
  file(GLOB found ${unpacked}/${name}-*/${folder})
  set(${result} ${found} PARENT_SCOPE)
endfunction()
unpack_source(openmesh OpenMesh openmesh)
unpack_source(pyglm PyGLM_lib/glm glm)

set(OPENMESH_INCLUDE_DIRS ${openmesh}/src)
set(core ${openmesh}/src/OpenMesh/Core)
add_library(OpenMeshCore STATIC
  ${core}/Mesh/ArrayKernel.cc
  ${core}/Mesh/BaseKernel.cc
  ${core}/Mesh/PolyConnectivity.cc
  ${core}/Mesh/TriConnectivity.cc
  ${core}/System/omstream.cc
  ${core}/Utils/BaseProperty.cc)
target_include_directories(OpenMeshCore SYSTEM PUBLIC ${OPENMESH_INCLUDE_DIRS})
target_compile_options(OpenMeshCore PRIVATE -w)

add_library(glm::glm INTERFACE IMPORTED GLOBAL)
target_include_directories(glm::glm SYSTEM INTERFACE ${glm})

install(FILES ${openmesh}/LICENSE COMPONENT licenses DESTINATION ${VTKSHADOW_LICENSES} RENAME OpenMesh.txt)
install(FILES ${glm}/copying.txt COMPONENT licenses DESTINATION ${VTKSHADOW_LICENSES} RENAME GLM.txt)
