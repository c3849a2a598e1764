# The real libftdi over an emulated FT232H.
include(${PROJECT_SOURCE_DIR}/targets/emulated-ftdi/emulated-ftdi.cmake)
pkg_check_modules(EAGERX_LIBFTDI REQUIRED IMPORTED_TARGET libftdi1)
add_executable(ftdi_link_test ${CMAKE_CURRENT_LIST_DIR}/link_test.cpp)
# The emulator comes first, so that its functions are the ones that libftdi finds.
target_link_libraries(ftdi_link_test PRIVATE eagerx_warnings eagerx::runtime -Wl,--no-as-needed emulated_ftdi
                                             GTest::gtest_main PkgConfig::EAGERX_LIBFTDI)
gtest_discover_tests(ftdi_link_test TEST_PREFIX ftdi. DISCOVERY_TIMEOUT 60)
