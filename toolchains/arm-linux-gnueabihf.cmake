# Linux on 32-bit Arm with a floating-point unit (ARMv7), cross-compiled (Debian: g++-arm-linux-gnueabihf).
include(${CMAKE_CURRENT_LIST_DIR}/need-compiler.cmake)
eagerx_need_compiler(arm-linux-gnueabihf-g++ g++-arm-linux-gnueabihf)
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR armv7)
set(CMAKE_CXX_COMPILER arm-linux-gnueabihf-g++)
# CMake's own choice for Release is -O3; one choice for all targets.
set(CMAKE_CXX_FLAGS_RELEASE "-O2 -DNDEBUG" CACHE STRING "Flags of a release build")
