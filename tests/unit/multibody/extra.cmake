# What is always inlined takes -Og three times as long to compile, and with sanitizers finding the places of variables
# takes GCC 12 longer than 18 minutes.
target_compile_options(test_multibody PRIVATE -O1 -g1 -fno-var-tracking -Wdouble-promotion)
