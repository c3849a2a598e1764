# Headers together with the macros of Arduino's cores, for this machine and, where there is the compiler, for a Cortex-M4F.
add_test(NAME packages.macros COMMAND ${CMAKE_CURRENT_LIST_DIR}/macros/run ${CMAKE_CXX_COMPILER})
