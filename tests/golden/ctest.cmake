# The generated code of some graphs is the one that is checked in.
add_test(NAME golden COMMAND ${CMAKE_CURRENT_LIST_DIR}/run $<TARGET_FILE:eagerx-gen>)
add_test(NAME golden_comments COMMAND ${CMAKE_CURRENT_LIST_DIR}/comments $<TARGET_FILE:eagerx-gen>)
