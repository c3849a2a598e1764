# Arrays, composites and variants are the graphs that they stand for.
add_test(NAME compose COMMAND ${CMAKE_CURRENT_LIST_DIR}/run $<TARGET_FILE:eagerx-gen>)
add_test(NAME compose.tuned COMMAND ${CMAKE_CURRENT_LIST_DIR}/tuned $<TARGET_FILE:eagerx-gen>)
set_tests_properties(compose.tuned PROPERTIES COST 100 LABELS long)
