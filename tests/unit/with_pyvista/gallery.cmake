# The gallery of examples/pyvista and the viewer. Included by drop_in.cmake.
set(gallery ${CMAKE_CURRENT_BINARY_DIR}/gallery)
set(with_pyvista "PYTHONPATH=${CMAKE_BINARY_DIR}/lib/python:$ENV{PYTHONPATH}")

# Draws it without a display.
add_test(NAME PyVista.gallery COMMAND ${SHADOW_TEST_PYTHON} -B
  ${CMAKE_CURRENT_LIST_DIR}/test_gallery.py ${gallery})
set_tests_properties(PyVista.gallery PROPERTIES LABELS unit TIMEOUT 900 FIXTURES_SETUP gallery
  ENVIRONMENT "${with_pyvista}" SKIP_REGULAR_EXPRESSION "there is no PyVista;there is no drawing without a display")

# The page that was drawn, in a browser.
add_test(NAME PyVista.gallery_page COMMAND ${SHADOW_TEST_PYTHON} -B
  ${CMAKE_CURRENT_LIST_DIR}/test_gallery_page.py ${gallery})
set_tests_properties(PyVista.gallery_page PROPERTIES LABELS unit TIMEOUT 600 FIXTURES_REQUIRED gallery
  SKIP_REGULAR_EXPRESSION "there is no Chromium;there is no gallery")

add_test(NAME PyVista.viewer COMMAND ${on_display} ${SHADOW_TEST_PYTHON} -B
  ${CMAKE_CURRENT_LIST_DIR}/test_viewer.py)
set_tests_properties(PyVista.viewer PROPERTIES LABELS unit TIMEOUT 600 RESOURCE_LOCK x_server
  ENVIRONMENT "${with_pyvista}" SKIP_REGULAR_EXPRESSION "there is no PyVista;there is no display")
