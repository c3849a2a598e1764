# Budgets are tried as the command does.
target_link_libraries(test_size PRIVATE eagerx_gen_driver)
