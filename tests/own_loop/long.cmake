# A library for another tree: --standalone needs nothing of the installation, and the example's loop on a board.
add_test(NAME own_loop.standalone COMMAND ${CMAKE_CURRENT_LIST_DIR}/run $<TARGET_FILE:eagerx-gen>
         $<TARGET_FILE:replay_swing_up>)
# The same faults on an emulated Cortex-M4F: what leaves has the same bits.
add_test(NAME own_loop.board COMMAND ${CMAKE_CURRENT_LIST_DIR}/board ${CMAKE_BINARY_DIR})
