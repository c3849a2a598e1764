# The real libftdi over an emulated FT232H.
include(${PROJECT_SOURCE_DIR}/targets/emulated-ftdi/emulated-ftdi.cmake)
pkg_check_modules(EAGERX_LIBFTDI REQUIRED IMPORTED_TARGET libftdi1)
if(EAGERX_SANITIZE)
  # The sanitizer looks at the clock, which the emulator replaces, before the emulator can be there. So only drivers
  # and emulator are tested, linked together, with a clock of their own.
  get_target_property(sources emulated_ftdi SOURCES)
  add_executable(ftdi_link_test ${CMAKE_CURRENT_LIST_DIR}/link_test.cpp ${sources})
  target_compile_options(ftdi_link_test PRIVATE -include ${CMAKE_CURRENT_LIST_DIR}/own_clock.hpp)
  target_include_directories(ftdi_link_test SYSTEM PRIVATE ${EAGERX_LIBUSB_INCLUDE_DIRS})
  target_link_libraries(ftdi_link_test PRIVATE eagerx::runtime GTest::gtest_main PkgConfig::EAGERX_LIBFTDI)
  gtest_discover_tests(ftdi_link_test TEST_PREFIX ftdi. DISCOVERY_TIMEOUT 60)
  return()
endif()
add_executable(ftdi_link_test ${CMAKE_CURRENT_LIST_DIR}/link_test.cpp)
# The emulator comes first, so that its functions are the ones that libftdi finds.
target_link_libraries(ftdi_link_test PRIVATE eagerx_warnings eagerx::runtime -Wl,--no-as-needed emulated_ftdi
                                             GTest::gtest_main PkgConfig::EAGERX_LIBFTDI)
gtest_discover_tests(ftdi_link_test TEST_PREFIX ftdi. DISCOVERY_TIMEOUT 60)

# RealEngine on it. tests/ftdi/soak is the long run with faults.
eagerx_add_graph(TARGET ftdi_swing_up GRAPH ${PROJECT_SOURCE_DIR}/examples/pendulum_swing_up/graph.yaml ENGINE RealEngine)
eagerx_add_graph(TARGET ftdi_soak GRAPH ${CMAKE_CURRENT_LIST_DIR}/soak.yaml)
eagerx_add_graph(TARGET ftdi_asynchronous GRAPH ${CMAKE_CURRENT_LIST_DIR}/asynchronous.yaml)
eagerx_add_graph(TARGET ftdi_fast GRAPH ${CMAKE_CURRENT_LIST_DIR}/fast.yaml)
eagerx_add_graph(TARGET ftdi_no_alloc GRAPH ${PROJECT_SOURCE_DIR}/examples/pendulum_swing_up/graph.yaml ENGINE RealEngine)
target_sources(ftdi_no_alloc PRIVATE ${PROJECT_SOURCE_DIR}/tests/support/no_alloc.cpp)
add_test(NAME ftdi COMMAND ${CMAKE_CURRENT_LIST_DIR}/run $<TARGET_FILE:emulated_ftdi> $<TARGET_FILE:ftdi_swing_up>
                           $<TARGET_FILE:ftdi_no_alloc> $<TARGET_FILE:ftdi_soak> $<TARGET_FILE:ftdi_asynchronous>)
