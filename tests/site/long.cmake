# The reference: every link leads somewhere, every entity and key has its place, twice the same bytes; what it plots is what
# the program of responses.yaml writes (the target site.responses.update writes it anew).
set(site ${PROJECT_SOURCE_DIR}/toolchains/site)
add_test(NAME site COMMAND /usr/bin/python3 -B ${CMAKE_CURRENT_LIST_DIR}/run $<TARGET_FILE:eagerx-gen>)
add_test(NAME site.falsified COMMAND /usr/bin/python3 -B ${CMAKE_CURRENT_LIST_DIR}/falsify)
eagerx_add_graph(TARGET site_responses GRAPH ${site}/responses.yaml)
eagerx_add_test(NAME site.responses TARGET site_responses EXPECTED ${site}/responses.csv OPTIONS --steps 200)
add_test(NAME site.browser COMMAND ${CMAKE_CURRENT_LIST_DIR}/../browser/site $<TARGET_FILE:eagerx-gen>)
set_tests_properties(site.browser PROPERTIES SKIP_RETURN_CODE 77 COST 20) # Chromium is a package of the long tests
