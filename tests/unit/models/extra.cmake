# The models are for boards too.
target_compile_options(test_models PRIVATE -Wdouble-promotion)
