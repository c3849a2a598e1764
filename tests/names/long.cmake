# Foreign text stays text in every file that is written. All texts: tests/names/run BUILD_FOLDER.
add_test(NAME names COMMAND ${CMAKE_CURRENT_LIST_DIR}/run ${PROJECT_BINARY_DIR} --short)
set_tests_properties(names PROPERTIES COST 80)
