# A project outside the tree, with find_package and with the build tree.
add_test(NAME install COMMAND ${CMAKE_CURRENT_LIST_DIR}/run ${PROJECT_BINARY_DIR})
set_tests_properties(install PROPERTIES COST 80)
