target_link_libraries(test_runtime PRIVATE mpfr gmp) # the reference of math_test.cpp
find_package(Eigen3 REQUIRED NO_MODULE)
target_link_libraries(test_runtime PRIVATE Eigen3::Eigen)
# Packs are passed to functions that are inlined: how a call would pass them does not matter.
target_compile_options(test_runtime PRIVATE -Wno-psabi)
# The same in the widest registers of this machine.
add_executable(test_pack_native ${CMAKE_CURRENT_LIST_DIR}/pack_test.cpp ${CMAKE_CURRENT_LIST_DIR}/policy_packs_test.cpp
                                ${CMAKE_CURRENT_LIST_DIR}/lane_random_test.cpp)
set_target_properties(test_pack_native PROPERTIES UNITY_BUILD ${EAGERX_UNITY} UNITY_BUILD_BATCH_SIZE 0)
target_link_libraries(test_pack_native PRIVATE eagerx_warnings eagerx::runtime GTest::gtest_main)
target_compile_options(test_pack_native PRIVATE -march=native -Wno-psabi)
gtest_discover_tests(test_pack_native TEST_PREFIX native. DISCOVERY_TIMEOUT 60)
