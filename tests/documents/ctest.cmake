# Links, anchors and citations of the documents; and whether mistakes in them are found.
find_package(Python3 REQUIRED COMPONENTS Interpreter)
add_test(NAME documents COMMAND Python3::Interpreter ${CMAKE_CURRENT_LIST_DIR}/run ${PROJECT_SOURCE_DIR})
add_test(NAME documents.falsified COMMAND Python3::Interpreter ${CMAKE_CURRENT_LIST_DIR}/falsify)
