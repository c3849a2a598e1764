# Requirements of all code that includes the runtime, as properties of the target eagerx_runtime.
target_compile_features(eagerx_runtime INTERFACE cxx_std_20)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/flags.txt)
file(STRINGS ${CMAKE_CURRENT_LIST_DIR}/flags.txt eagerx_flags REGEX "^[^#]")
list(TRANSFORM eagerx_flags REPLACE "^([A-Za-z]+): (.+)$" "$<$<CXX_COMPILER_ID:\\1>:\\2>")
target_compile_options(eagerx_runtime INTERFACE ${eagerx_flags})
