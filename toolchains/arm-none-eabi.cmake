# GNU Arm Embedded for bare metal. The toolchain file of a core sets EAGERX_CPU_FLAGS and includes this one.
include(${CMAKE_CURRENT_LIST_DIR}/need-compiler.cmake)
eagerx_need_compiler(arm-none-eabi-g++ gcc-arm-none-eabi libnewlib-arm-none-eabi
                     libstdc++-arm-none-eabi-dev libstdc++-arm-none-eabi-newlib)
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_C_COMPILER arm-none-eabi-gcc)
set(CMAKE_CXX_COMPILER arm-none-eabi-g++)
set(CMAKE_SIZE arm-none-eabi-size)
# CMake's trial programs cannot be linked: start-up code and linker script belong to a target.
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
set(CMAKE_C_FLAGS_INIT "${EAGERX_CPU_FLAGS}")
set(CMAKE_CXX_FLAGS_INIT "${EAGERX_CPU_FLAGS}")
# CMake's own choice for Release is -O3, which costs half as much flash again for a few percent of time.
set(CMAKE_CXX_FLAGS_RELEASE "-O2 -DNDEBUG" CACHE STRING "Flags of a release build")
