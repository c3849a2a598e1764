target_link_libraries(test_runtime PRIVATE mpfr gmp) # the reference of math_test.cpp
find_package(Eigen3 REQUIRED NO_MODULE)
target_link_libraries(test_runtime PRIVATE Eigen3::Eigen)
