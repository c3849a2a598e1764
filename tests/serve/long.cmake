# Minutes: each edit is checked as a whole graph.
add_test(NAME serve.more_edits COMMAND Python3::Interpreter -B ${CMAKE_CURRENT_LIST_DIR}/edits $<TARGET_FILE:eagerx-gen> 150)
set_tests_properties(serve.more_edits PROPERTIES SKIP_RETURN_CODE 77 COST 60)
# It builds the program of a loop.
add_test(NAME serve.loop COMMAND Python3::Interpreter -B ${CMAKE_CURRENT_LIST_DIR}/loop $<TARGET_FILE:eagerx-gen>)
set_tests_properties(serve.loop PROPERTIES SKIP_RETURN_CODE 77 COST 30)
