# For tests that look at the messages of libraries of environments, and not at their speed: packs for this machine alone,
# with the same bits in a third of the time to compile. `export CMAKE_TOOLCHAIN_FILE=…/quick_packs.cmake` reaches what
# `eagerx-gen campaign`, `train` and Python's `make` build; this says nothing of a system, so nothing is cross-compiled.
set(EAGERX_INSTRUCTION_SETS native)
set(EAGERX_PACKS_LEVEL -Og)
