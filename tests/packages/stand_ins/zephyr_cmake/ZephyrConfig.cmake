# find_package(Zephyr) for the compiler of this machine: modules, their Kconfig with prj.conf, the target `app`, and
# the functions of Zephyr's CMake that modules call. FPU says whether the processor has one.
project(Zephyr-Kernel LANGUAGES C CXX)
set(stand_ins ${CMAKE_CURRENT_LIST_DIR}/..)
add_library(zephyr_interface INTERFACE)
target_include_directories(zephyr_interface INTERFACE ${stand_ins})
target_compile_options(zephyr_interface INTERFACE -Wall -Wextra -Werror -fno-exceptions -fno-rtti)
function(zephyr_include_directories)
  target_include_directories(zephyr_interface INTERFACE ${ARGN})
endfunction()
function(zephyr_compile_options)
  target_compile_options(zephyr_interface INTERFACE ${ARGN})
endfunction()

foreach(module IN LISTS EXTRA_ZEPHYR_MODULES)
  execute_process(
    COMMAND ${PYTHON} ${CMAKE_CURRENT_LIST_DIR}/kconfig.py ${module} ${CMAKE_SOURCE_DIR}/prj.conf ${FPU}
            ${CMAKE_BINARY_DIR}/config.cmake
    COMMAND_ERROR_IS_FATAL ANY)
  include(${CMAKE_BINARY_DIR}/config.cmake)
  add_subdirectory(${module}/${MODULE_CMAKE} modules)
endforeach()
if(NOT CONFIG_CPP OR NOT CONFIG_STD_CPP20)
  message(FATAL_ERROR "no C++20")
endif()
set(CMAKE_CXX_STANDARD 20)
add_executable(app)
target_link_libraries(app PRIVATE zephyr_interface)
