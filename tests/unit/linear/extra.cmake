target_include_directories(test_linear SYSTEM PRIVATE ${EAGERX_EIGEN})
