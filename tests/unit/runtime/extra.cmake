target_link_libraries(test_runtime PRIVATE mpfr gmp) # the reference of math_test.cpp
find_package(Eigen3 REQUIRED NO_MODULE)
target_link_libraries(test_runtime PRIVATE Eigen3::Eigen)
# SIMD vectors are passed to functions that are inlined: how a call would pass them does not matter.
target_compile_options(test_runtime PRIVATE -Wno-psabi)
