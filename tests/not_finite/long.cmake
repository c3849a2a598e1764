# Rewards that are not numbers, in the program, in libraries, trainer and campaign, on an emulated board.
if(EAGERX_SANITIZE)
  return() # the library is opened by programs without sanitizers
endif()
eagerx_add_graph(TARGET not_finite GRAPH ${CMAKE_CURRENT_LIST_DIR}/not_finite.yaml)
eagerx_add_graph(TARGET not_finite_library GRAPH ${CMAKE_CURRENT_LIST_DIR}/not_finite.yaml BOARD environments)
# The same in doubles, whose rewards and terms are doubles.
file(READ ${CMAKE_CURRENT_LIST_DIR}/not_finite.yaml text)
string(REPLACE "rate: 50 Hz\nlibrary: [../data" "real: double\nrate: 50 Hz\nlibrary: [${PROJECT_SOURCE_DIR}/tests/data" text
               "${text}")
file(CONFIGURE OUTPUT not_finite_double.yaml CONTENT "${text}" @ONLY)
set(double ${CMAKE_CURRENT_BINARY_DIR}/not_finite_double.yaml)
eagerx_add_graph(TARGET not_finite_double GRAPH ${double})
eagerx_add_graph(TARGET not_finite_double_library GRAPH ${double} BOARD environments)
add_test(NAME not_finite COMMAND ${CMAKE_CURRENT_LIST_DIR}/run ${PROJECT_BINARY_DIR} $<TARGET_FILE:not_finite>
                                 $<TARGET_FILE:not_finite_library> $<TARGET_FILE:campaign_delays_alone>
                                 $<TARGET_FILE:not_finite_double> $<TARGET_FILE:not_finite_double_library>)
