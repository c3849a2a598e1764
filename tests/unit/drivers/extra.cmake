# The drivers are for boards too.
target_compile_options(test_drivers PRIVATE -Wdouble-promotion)
