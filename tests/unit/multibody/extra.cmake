# Functions that are always inlined take three times as long to compile with -Og. With so much inlining, GCC 12 needs
# minutes per file to check the use of variables after their scope, and as long for these three checks, which the
# address sanitizer makes, too.
target_compile_options(test_multibody PRIVATE -O1 -Wdouble-promotion
  $<$<BOOL:${EAGERX_SANITIZE}>:-fno-sanitize=null,alignment,object-size -fno-sanitize-address-use-after-scope>
  $<$<AND:$<BOOL:${EAGERX_SANITIZE}>,$<CXX_COMPILER_ID:GNU>>:-fno-var-tracking-assignments>)
if(EAGERX_SANITIZE) # the precompiled header is that of -O0
  set_target_properties(test_multibody PROPERTIES UNITY_BUILD OFF DISABLE_PRECOMPILE_HEADERS ON)
endif()
