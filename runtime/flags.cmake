# What everything that is compiled with the runtime must have, for the target eagerx_runtime.
target_compile_features(eagerx_runtime INTERFACE cxx_std_20)
# FMA contraction changes the last bit from machine to machine; errno keeps sqrt from being one instruction;
# nobody looks at floating-point traps, but keeping them costs select() its vector form.
target_compile_options(eagerx_runtime INTERFACE -fno-fast-math -ffp-contract=off -fno-math-errno -fno-trapping-math)
# g++ 12 packs the few numbers of an integrator's state into vectors and unpacks them at every stage: slower by up
# to 4 % on the example, and a tenth of the compile time of large graphs (tests/bench). Loops are still vectorised.
target_compile_options(eagerx_runtime INTERFACE $<$<CXX_COMPILER_ID:GNU>:-fno-tree-slp-vectorize>)
