# The modules of the page of eagerx-gen report, in Node. tests/browser looks at pages in a browser.
find_program(eagerx_node NAMES node nodejs)
if(NOT eagerx_node)
  eagerx_left_out(page "there is no Node (toolchains/install-packages tests)")
  return()
endif()
file(GLOB page_tests CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/*.test.mjs)
add_test(NAME page COMMAND ${eagerx_node} --test ${page_tests})
set_tests_properties(page PROPERTIES ENVIRONMENT EAGERX_BUILD=${PROJECT_BINARY_DIR})
