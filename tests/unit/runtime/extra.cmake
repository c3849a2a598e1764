target_link_libraries(test_runtime PRIVATE mpfr gmp) # the reference of math_test.cpp
