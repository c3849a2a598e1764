# The generated code of some graphs is the one that is checked in.
add_test(NAME golden COMMAND ${CMAKE_CURRENT_LIST_DIR}/run $<TARGET_FILE:eagerx-gen>)
add_test(NAME golden_comments COMMAND ${CMAKE_CURRENT_LIST_DIR}/comments $<TARGET_FILE:eagerx-gen>)
# It looks as if it were written by hand; with another version of clang-format it is not judged.
add_test(NAME golden_formatted COMMAND ${CMAKE_CURRENT_LIST_DIR}/formatted $<TARGET_FILE:eagerx-gen>)
set_tests_properties(golden_formatted PROPERTIES SKIP_RETURN_CODE 77)
