# Pages of eagerx-gen report in headless Chromium, simulations among them: two minutes, so it is one of the long tests.
if(EAGERX_SANITIZE)
  return() # a browser finds nothing that a sanitizer could see
endif()
add_test(NAME browser COMMAND ${CMAKE_CURRENT_LIST_DIR}/run ${PROJECT_BINARY_DIR})
set_tests_properties(browser PROPERTIES SKIP_RETURN_CODE 77 LABELS long)
