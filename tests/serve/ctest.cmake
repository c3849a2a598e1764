# The server of the page that edits: who may ask what, and what becomes of a file.
find_package(Python3 REQUIRED COMPONENTS Interpreter)
add_test(NAME serve COMMAND Python3::Interpreter -B ${CMAKE_CURRENT_LIST_DIR}/run $<TARGET_FILE:eagerx-gen>)
add_test(NAME serve.edits COMMAND Python3::Interpreter -B ${CMAKE_CURRENT_LIST_DIR}/edits $<TARGET_FILE:eagerx-gen> 30)
set_tests_properties(serve serve.edits PROPERTIES SKIP_RETURN_CODE 77)
