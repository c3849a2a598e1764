# All of it is linux-sim's; only the compiler is another.
include(${EAGERX_TARGETS_DIR}/linux-sim/target.cmake)
