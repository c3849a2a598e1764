# The generated code of some graphs is the one that is checked in.
add_test(NAME golden COMMAND ${CMAKE_CURRENT_LIST_DIR}/run $<TARGET_FILE:eagerx-gen>)
