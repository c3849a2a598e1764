# Generated code as a safety review wants it; what runtime/DEVIATIONS.md says is tried.
add_test(NAME review COMMAND ${CMAKE_CURRENT_LIST_DIR}/run $<TARGET_FILE:eagerx-gen>)
set_tests_properties(review PROPERTIES COST 110)
