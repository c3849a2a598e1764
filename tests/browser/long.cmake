# Pages of eagerx-gen report in headless Chromium, simulations among them: two minutes, so it is one of the long tests.
if(EAGERX_SANITIZE)
  return() # a browser finds nothing that a sanitizer could see
endif()
add_test(NAME browser COMMAND ${CMAKE_CURRENT_LIST_DIR}/run ${PROJECT_BINARY_DIR})
set_tests_properties(browser PROPERTIES SKIP_RETURN_CODE 77 COST 50)
# The page of eagerx-gen serve: graphs made with pointer and keyboard; builds their programs, and trains: some minutes.
add_test(NAME serve.browser COMMAND ${CMAKE_CURRENT_LIST_DIR}/serve ${PROJECT_BINARY_DIR})
set_tests_properties(serve.browser PROPERTIES SKIP_RETURN_CODE 77 COST 120 TIMEOUT 1800)
