# Linux on 64-bit Arm, cross-compiled (Debian: g++-aarch64-linux-gnu).
include(${CMAKE_CURRENT_LIST_DIR}/need-compiler.cmake)
eagerx_need_compiler(aarch64-linux-gnu-g++ g++-aarch64-linux-gnu)
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)
# CMake's own choice for Release is -O3; one choice for all targets.
set(CMAKE_CXX_FLAGS_RELEASE "-O2 -DNDEBUG" CACHE STRING "Flags of a release build")
