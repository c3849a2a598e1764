# The same bits from both compilers at every optimisation level.
add_test(NAME math_bits COMMAND ${CMAKE_CURRENT_LIST_DIR}/run.sh)
# Flags that change them are refused.
add_test(NAME math_flags COMMAND ${CMAKE_CURRENT_LIST_DIR}/flags ${PROJECT_BINARY_DIR})
