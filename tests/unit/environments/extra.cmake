# Code that libraries of environments share, with this project's warnings.
include(${PROJECT_SOURCE_DIR}/targets/environments/libraries.cmake)
eagerx_environments_libraries()
target_link_libraries(test_environments PRIVATE eagerx_environments)
target_link_libraries(eagerx_environments PRIVATE eagerx_warnings)
