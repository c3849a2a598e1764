# The line of a part in Python.
add_test(NAME languages.line COMMAND ${CMAKE_CURRENT_LIST_DIR}/line $<TARGET_FILE:eagerx-gen>)
