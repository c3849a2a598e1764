# The language server: by a client of our own, at places where graphs are cut off, in Neovim.
find_package(Python3 REQUIRED COMPONENTS Interpreter)
add_test(NAME lsp COMMAND Python3::Interpreter -B ${CMAKE_CURRENT_LIST_DIR}/run $<TARGET_FILE:eagerx-gen>)
add_test(NAME lsp.completion COMMAND Python3::Interpreter -B ${CMAKE_CURRENT_LIST_DIR}/completion $<TARGET_FILE:eagerx-gen> 200)
add_test(NAME lsp.neovim COMMAND Python3::Interpreter -B ${CMAKE_CURRENT_LIST_DIR}/neovim $<TARGET_FILE:eagerx-gen>)
set_tests_properties(lsp.neovim PROPERTIES SKIP_RETURN_CODE 77)
