# Which symbols an image must not have.
add_test(NAME firmware.symbols COMMAND ${CMAKE_CURRENT_LIST_DIR}/symbols)
