# What is always inlined takes -Og three times as long to compile. With both sanitizers GCC 12 does not finish all files as
# one within 18 minutes, and without these three checks, which the address sanitizer makes, too, one file takes half a minute.
target_compile_options(test_multibody PRIVATE -O1 -Wdouble-promotion
  $<$<BOOL:${EAGERX_SANITIZE}>:-fno-sanitize=null,alignment,object-size -fno-var-tracking-assignments>)
if(EAGERX_SANITIZE) # the precompiled header is that of -O0
  set_target_properties(test_multibody PROPERTIES UNITY_BUILD OFF DISABLE_PRECOMPILE_HEADERS ON)
endif()
