# The emulated FT232H as a shared library, to be loaded before libusb-1.0: LD_PRELOAD=<file> PROGRAM, or linked
# before libftdi1. Target emulated_ftdi.
if(NOT TARGET emulated_ftdi)
  find_package(PkgConfig REQUIRED)
  pkg_check_modules(EAGERX_LIBUSB REQUIRED libusb-1.0)
  set(here ${CMAKE_CURRENT_LIST_DIR})
  add_library(emulated_ftdi SHARED EXCLUDE_FROM_ALL ${here}/chip.cpp ${here}/emulator.cpp ${here}/faults.cpp
                                                    ${here}/libusb.cpp ${here}/pendulum_rig.cpp ${here}/time.cpp)
  target_include_directories(emulated_ftdi SYSTEM PRIVATE ${EAGERX_LIBUSB_INCLUDE_DIRS}) # the header only
  target_link_libraries(emulated_ftdi PUBLIC eagerx::runtime)
  target_compile_options(emulated_ftdi PRIVATE -Wall -Wextra $<$<CONFIG:>:-O2>)
endif()
