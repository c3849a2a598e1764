# WebAssembly, by Debian's Emscripten. The first program that is built makes Emscripten's own libraries, in EM_CACHE or
# ~/.cache/emscripten.
include(${CMAKE_CURRENT_LIST_DIR}/need-compiler.cmake)
eagerx_need_compiler(em++ emscripten)
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR wasm32)
set(CMAKE_CXX_COMPILER em++)
set(CMAKE_AR emar CACHE STRING "Archiver")
set(CMAKE_RANLIB emranlib CACHE STRING "Indexer of archives")
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
# CMake's own choice for Release is -O3; one choice for all targets.
set(CMAKE_CXX_FLAGS_RELEASE "-O2 -DNDEBUG" CACHE STRING "Flags of a release build")
