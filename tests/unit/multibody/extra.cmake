# What is always inlined takes -Og three times as long to compile. With both sanitizers GCC 12 takes more than two minutes for
# each file, and more than 18 for all as one; with that of addresses half a minute for each. Programs of robots have both.
target_compile_options(test_multibody PRIVATE -O1 -Wdouble-promotion
  $<$<BOOL:${EAGERX_SANITIZE}>:-fno-sanitize=undefined -fno-var-tracking-assignments>)
if(EAGERX_SANITIZE) # the precompiled header is that of -O0
  set_target_properties(test_multibody PROPERTIES UNITY_BUILD OFF DISABLE_PRECOMPILE_HEADERS ON)
endif()
