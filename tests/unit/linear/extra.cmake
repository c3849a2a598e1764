target_include_directories(test_linear SYSTEM PRIVATE ${EAGERX_EIGEN})
# As eagerx_gen_algebra: GCC 12 keeps __OPTIMIZE__ of fmt's pragma in a precompiled header, and then Eigen does not compile.
set_target_properties(test_linear PROPERTIES DISABLE_PRECOMPILE_HEADERS ON)
