# What is always inlined takes -Og three times as long to compile. Where so much is inlined, GCC 12 needs minutes for each
# file to see whether a variable is used after its scope, and as long for these three checks, which the address sanitizer
# makes, too.
target_compile_options(test_multibody PRIVATE -O1 -Wdouble-promotion
  $<$<BOOL:${EAGERX_SANITIZE}>:-fno-sanitize=null,alignment,object-size -fno-sanitize-address-use-after-scope
  -fno-var-tracking-assignments>)
if(EAGERX_SANITIZE) # the precompiled header is that of -O0
  set_target_properties(test_multibody PROPERTIES UNITY_BUILD OFF DISABLE_PRECOMPILE_HEADERS ON)
endif()
