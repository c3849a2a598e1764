# The server of the page that edits: who may ask what, and what becomes of a file.
find_package(Python3 REQUIRED COMPONENTS Interpreter)
foreach(name run edits)
  string(REPLACE .run "" test serve.${name})
  add_test(NAME ${test} COMMAND Python3::Interpreter -B ${CMAKE_CURRENT_LIST_DIR}/${name} $<TARGET_FILE:eagerx-gen>)
  set_tests_properties(${test} PROPERTIES SKIP_RETURN_CODE 77)
endforeach()
