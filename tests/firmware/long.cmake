# Images that run, fault in the right words, or must not link. The others: tests/firmware/run by hand.
add_test(NAME firmware COMMAND ${CMAKE_CURRENT_LIST_DIR}/run --short ${PROJECT_BINARY_DIR} ${CMAKE_CURRENT_BINARY_DIR}/firmware
                               mps2-an385 mps2-an386 mps2-an500 stm32f405)
add_test(NAME firmware.others COMMAND ${CMAKE_CURRENT_LIST_DIR}/run --short ${PROJECT_BINARY_DIR}
                                      ${CMAKE_CURRENT_BINARY_DIR}/firmware.others riscv32-virt linux-aarch64)
set_tests_properties(firmware PROPERTIES COST 1000) # first
set_tests_properties(firmware.others PROPERTIES COST 250) # later: then programs that both compile are in ccache
