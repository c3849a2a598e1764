# Every block of the library, 2^26 ticks in float against double.
add_executable(numerics_campaign ${CMAKE_CURRENT_LIST_DIR}/campaign.cpp)
target_link_libraries(numerics_campaign PRIVATE eagerx_warnings eagerx::runtime GTest::gtest)
target_compile_definitions(numerics_campaign PRIVATE EAGERX_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
target_compile_options(numerics_campaign PRIVATE -O2)
add_test(NAME numerics.campaign COMMAND numerics_campaign)
set_tests_properties(numerics.campaign PROPERTIES COST 200)
