# `cpack` in a build folder makes eagerx-gen_VERSION_ARCHITECTURE.deb of everything that has an install rule, in /usr.
# tests/deb/run tries it.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME eagerx-gen)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_CONTACT "eagerx-gen developers <maintainers@users.noreply.h-seed-552e7f32.example>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "static code generator for graphs of robots")
set(CPACK_PACKAGE_DESCRIPTION
    "eagerx-gen reads a robotic environment, described as a graph of nodes, objects\nand an engine in the words of EAGERx, \
checks it, and writes a C++20 program for\nit. The same graph runs in simulation on Linux and on a microcontroller without\n\
an operating system, with a trained policy's weights in flash, and gives the\nsame messages, bit for bit.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_THREADS 0)
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR})
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION devel)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# Recommended: packages that build programs, and libraries that `report --live`, `--publish` and `--key` open at run time.
# Suggested: packages that speed up builds, and those that only some graphs and boards need.
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "g++, cmake (>= 3.25), ninja-build, pkg-config, gcc-arm-none-eabi, libnewlib-arm-none-eabi, \
libstdc++-arm-none-eabi-newlib, libstdc++-arm-none-eabi-dev, qemu-system-arm, ffmpeg, libsdl2-2.0-0, libwebsockets-dev, libsodium23")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS
    "ccache, gcc-riscv64-unknown-elf, picolibc-riscv64-unknown-elf, qemu-system-misc, \
g++-aarch64-linux-gnu, g++-arm-linux-gnueabihf, qemu-user, libode-dev, libftdi1-dev, \
cyclonedds-dev, cyclonedds-tools, emscripten, nodejs")
if(CMAKE_CROSSCOMPILING)
  set(debian_names x86_64 amd64 aarch64 arm64 armv7 armhf)
  list(FIND debian_names "${CMAKE_SYSTEM_PROCESSOR}" index)
  if(index GREATER -1)
    math(EXPR index "${index} + 1")
    list(GET debian_names ${index} CPACK_DEBIAN_PACKAGE_ARCHITECTURE)
  endif()
endif()

# Debian wants its own changelog and copyright, and compresses pages.
set(documents ${CMAKE_INSTALL_DATADIR}/doc/eagerx-gen)
string(TIMESTAMP debian_date "%a, %d %b %Y %H:%M:%S +0000" UTC)
configure_file(${CMAKE_CURRENT_LIST_DIR}/changelog.in ${PROJECT_BINARY_DIR}/debian/changelog @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/debian/changelog ${CMAKE_CURRENT_LIST_DIR}/copyright DESTINATION ${documents})
install(FILES ${PROJECT_SOURCE_DIR}/CHANGELOG.md DESTINATION ${documents} RENAME NEWS.md)
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_LIST_DIR}/compress.cmake)
include(CPack)
