# Every block of the library in float against double: 2^20 ticks from tick 2^26 on. tests/numerics/run takes 2^26 of them.
add_executable(numerics_campaign ${CMAKE_CURRENT_LIST_DIR}/campaign.cpp)
target_link_libraries(numerics_campaign PRIVATE eagerx_warnings eagerx::runtime GTest::gtest)
target_compile_definitions(numerics_campaign PRIVATE EAGERX_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
target_compile_options(numerics_campaign PRIVATE -O2)
add_test(NAME numerics.campaign COMMAND numerics_campaign 1048576)
set_tests_properties(numerics.campaign PROPERTIES COST 20)
