# No include goes against the order of the libraries, and the picture in generator/README.md shows that order.
include(${CMAKE_CURRENT_LIST_DIR}/links.cmake)
eagerx_write_links(${PROJECT_BINARY_DIR}/links.txt ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/runtime
                   ${PROJECT_SOURCE_DIR}/generator)
add_test(NAME architecture COMMAND ${CMAKE_CURRENT_LIST_DIR}/run ${PROJECT_BINARY_DIR})
