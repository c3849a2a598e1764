# The parts of linux-sim that do not depend on a graph, with this project's warnings.
include(${PROJECT_SOURCE_DIR}/targets/linux-sim/target.cmake)
eagerx_configure_target(test_targets)
foreach(library eagerx_linux_sim eagerx_pictures)
  target_link_libraries(${library} PRIVATE eagerx_warnings)
endforeach()
