# The parts of linux-sim that do not depend on a graph, with this project's warnings.
include(${PROJECT_SOURCE_DIR}/targets/linux-sim/target.cmake)
eagerx_configure_target(test_targets)
target_link_libraries(eagerx_linux_sim PRIVATE eagerx_warnings)
