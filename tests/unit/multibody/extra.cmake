# What is always inlined takes -Og three times as long to compile.
target_compile_options(test_multibody PRIVATE -O1 -Wdouble-promotion)
