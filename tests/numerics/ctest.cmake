# Nodes that compute time by the helpers only.
find_package(Python3 REQUIRED COMPONENTS Interpreter)
add_test(NAME numerics.times COMMAND Python3::Interpreter ${CMAKE_CURRENT_LIST_DIR}/times ${PROJECT_SOURCE_DIR})
add_test(NAME numerics.times_falsify COMMAND Python3::Interpreter ${CMAKE_CURRENT_LIST_DIR}/times --falsify ${PROJECT_SOURCE_DIR})
