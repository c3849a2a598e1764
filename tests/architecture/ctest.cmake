# No include goes against the order of the libraries, and the picture in generator/README.md shows that order.
include(${CMAKE_CURRENT_LIST_DIR}/links.cmake)
eagerx_write_links(${PROJECT_BINARY_DIR}/links.txt ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/runtime
                   ${PROJECT_SOURCE_DIR}/generator)
add_test(NAME architecture COMMAND ${CMAKE_CURRENT_LIST_DIR}/run ${PROJECT_BINARY_DIR})
add_test(NAME architecture.falsified COMMAND ${CMAKE_CURRENT_LIST_DIR}/falsify ${PROJECT_BINARY_DIR})
# Drawn again, and compared.
add_test(NAME architecture.drawn COMMAND ${CMAKE_CURRENT_LIST_DIR}/run ${PROJECT_BINARY_DIR} --draw)
set_tests_properties(architecture.drawn PROPERTIES COST 35 LABELS long)
