# Files that EAGERx saved, imported and rewritten.
add_test(NAME import COMMAND ${CMAKE_CURRENT_LIST_DIR}/run $<TARGET_FILE:eagerx-gen>)
add_test(NAME import_notebooks COMMAND ${CMAKE_CURRENT_LIST_DIR}/notebooks/run $<TARGET_FILE:eagerx-gen>)
add_test(NAME import_mutated COMMAND ${CMAKE_CURRENT_LIST_DIR}/mutated/run $<TARGET_FILE:eagerx-gen>)
