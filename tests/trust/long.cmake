# A line with a key, and peers without it.
add_test(NAME trust COMMAND ${CMAKE_CURRENT_LIST_DIR}/run ${PROJECT_BINARY_DIR} ${CMAKE_CURRENT_BINARY_DIR}/trust)
set_tests_properties(trust PROPERTIES COST 600) # compiles five programs, and waits for greetings of five seconds
add_test(NAME trust.languages COMMAND ${CMAKE_CURRENT_LIST_DIR}/run --languages ${PROJECT_BINARY_DIR}
  ${CMAKE_CURRENT_BINARY_DIR}/trust_languages)
set_tests_properties(trust.languages PROPERTIES COST 2000) # two parts, each with all attacks, and greetings of five seconds
