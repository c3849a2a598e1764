# Links, anchors, citations, tables, names and figures of the documents; and whether mistakes in them are found. They need
# Debian's python3-yaml.
add_test(NAME documents COMMAND /usr/bin/python3 -B ${CMAKE_CURRENT_LIST_DIR}/run ${PROJECT_SOURCE_DIR})
add_test(NAME documents.falsified COMMAND /usr/bin/python3 -B ${CMAKE_CURRENT_LIST_DIR}/falsify)
