# Minutes: each edit is checked as a whole graph.
add_test(NAME serve.more_edits COMMAND Python3::Interpreter -B ${CMAKE_CURRENT_LIST_DIR}/edits $<TARGET_FILE:eagerx-gen> 150)
set_tests_properties(serve.more_edits PROPERTIES SKIP_RETURN_CODE 77 COST 60)
