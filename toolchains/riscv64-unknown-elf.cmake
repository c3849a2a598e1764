# GNU RISC-V for bare metal, of any width. The toolchain file of a core sets EAGERX_CPU_FLAGS and includes this
# one. Debian's compiler comes without the headers of the C++ library; those for Arm
# (libstdc++-arm-none-eabi-dev) serve, for what the runtime takes from them depends on the compiler only and
# needs no library. The C library is picolibc.
include(${CMAKE_CURRENT_LIST_DIR}/need-compiler.cmake)
eagerx_need_compiler(riscv64-unknown-elf-g++ gcc-riscv64-unknown-elf picolibc-riscv64-unknown-elf
                     libstdc++-arm-none-eabi-dev)
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_C_COMPILER riscv64-unknown-elf-gcc)
set(CMAKE_CXX_COMPILER riscv64-unknown-elf-g++)
set(CMAKE_SIZE riscv64-unknown-elf-size)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
execute_process(COMMAND ${CMAKE_CXX_COMPILER} -dumpversion OUTPUT_VARIABLE EAGERX_COMPILER_VERSION)
string(REGEX MATCH "^[0-9]+" EAGERX_COMPILER_VERSION "${EAGERX_COMPILER_VERSION}")
file(GLOB EAGERX_BORROWED_HEADERS /usr/include/newlib/c++/${EAGERX_COMPILER_VERSION}.*)
if(NOT EAGERX_BORROWED_HEADERS)
  message(FATAL_ERROR "no C++ headers of g++ ${EAGERX_COMPILER_VERSION} for RISC-V: install libstdc++-arm-none-eabi-dev, or name a compiler that has its own")
endif()
list(GET EAGERX_BORROWED_HEADERS -1 EAGERX_BORROWED_HEADERS)
string(APPEND EAGERX_CPU_FLAGS " --specs=picolibc.specs -isystem ${EAGERX_BORROWED_HEADERS}"
              " -isystem ${EAGERX_BORROWED_HEADERS}/arm-none-eabi/thumb/v7-m/nofp")
set(CMAKE_C_FLAGS_INIT "${EAGERX_CPU_FLAGS}")
set(CMAKE_CXX_FLAGS_INIT "${EAGERX_CPU_FLAGS}")
set(CMAKE_CXX_FLAGS_RELEASE "-O2 -DNDEBUG" CACHE STRING "Flags of a release build")
