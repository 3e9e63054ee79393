# What a wheel is, unlike an installation: one folder beside VTK's package, with all in it. pyproject.toml asks for it.
if(NOT VTKSHADOW_VTK_PACKAGE)
  message(FATAL_ERROR "A wheel needs a VTK that is wrapped for Python")
endif()
set(CMAKE_INSTALL_LIBDIR vtkshadow)
set(VTKSHADOW_PYTHON_DESTINATION .)
set(VTKSHADOW_RPATH_TO_VTK "$ORIGIN/../${VTKSHADOW_VTK_PACKAGE}")
if(SKBUILD_METADATA_DIR)
  set(VTKSHADOW_LICENSES ${SKBUILD_METADATA_DIR}/licenses)
else()
  set(VTKSHADOW_LICENSES vtkshadow/licenses)
endif()

# From 9.4 on VTK's own window draws without a display.
set(VTKSHADOW_HEADLESS OFF)
set(VTKSHADOW_WRAP_PYTHON ON)
set(VTKSHADOW_BUILD_TESTS OFF)
set(VTKSHADOW_BUILD_EXAMPLES OFF)
