# Recordings of EAGERx, repeated; and recordings with a mistake put in, which must be found.
add_test(NAME conformance.recordings
         COMMAND ${CMAKE_CURRENT_LIST_DIR}/check --jobs 1 --generator $<TARGET_FILE:eagerx-gen>
                 ${CMAKE_CURRENT_LIST_DIR}/recordings)
add_test(NAME conformance.units COMMAND ${CMAKE_CURRENT_LIST_DIR}/units)
add_test(NAME conformance.falsified COMMAND ${CMAKE_CURRENT_LIST_DIR}/falsify $<TARGET_FILE:eagerx-gen>)
