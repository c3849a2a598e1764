# Commands that are killed; without the number 500 times each.
if(EAGERX_SANITIZE)
  return() # the library is opened by programs without sanitizers
endif()
foreach(kills train=3 campaign=6 generate=40 build=3 report=20)
  string(REGEX MATCH "([a-z]+)=([0-9]+)" unused ${kills})
  add_test(NAME kills.${CMAKE_MATCH_1} COMMAND ${CMAKE_CURRENT_LIST_DIR}/run ${PROJECT_BINARY_DIR} $<TARGET_FILE:environments_swing>
                                               ${CMAKE_MATCH_2} ${CMAKE_MATCH_1})
  set_tests_properties(kills.${CMAKE_MATCH_1} PROPERTIES COST 30)
endforeach()
