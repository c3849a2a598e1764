# Readers of policies with a fixed number of inputs, under sanitizers. It compiles these readers a second time, so it is
# part of tests/sanitize and not of tests/run. Longer, and all readers: tests/fuzz/run.
if(NOT EAGERX_SANITIZE)
  return()
endif()
add_test(NAME fuzz COMMAND ${CMAKE_CURRENT_LIST_DIR}/run --short ${CMAKE_CURRENT_BINARY_DIR}/fuzz)
set_tests_properties(fuzz PROPERTIES COST 1000) # long: first
