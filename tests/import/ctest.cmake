# Files that EAGERx saved, imported and rewritten.
add_test(NAME import COMMAND ${CMAKE_CURRENT_LIST_DIR}/run $<TARGET_FILE:eagerx-gen>)
