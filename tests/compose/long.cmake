# Arrays and composites whose parameters are tuned.
add_test(NAME compose.tuned COMMAND ${CMAKE_CURRENT_LIST_DIR}/tuned $<TARGET_FILE:eagerx-gen>)
set_tests_properties(compose.tuned PROPERTIES COST 100)
