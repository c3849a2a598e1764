# What is always inlined takes -Og three times as long to compile. With both sanitizers GCC 12 does not finish within 18
# minutes: the address sanitizer finds what these three checks would, and without them it is done in a twentieth.
target_compile_options(test_multibody PRIVATE -O1 -Wdouble-promotion
  $<$<BOOL:${EAGERX_SANITIZE}>:-fno-sanitize=null,alignment,object-size>)
