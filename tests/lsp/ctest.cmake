# The language server: by a client of our own, at places where graphs are cut off, in Neovim.
find_package(Python3 REQUIRED COMPONENTS Interpreter)
add_test(NAME lsp COMMAND Python3::Interpreter -B ${CMAKE_CURRENT_LIST_DIR}/run $<TARGET_FILE:eagerx-gen>)
add_test(NAME lsp.features COMMAND Python3::Interpreter -B ${CMAKE_CURRENT_LIST_DIR}/features $<TARGET_FILE:eagerx-gen>)
add_test(NAME lsp.completion COMMAND Python3::Interpreter -B ${CMAKE_CURRENT_LIST_DIR}/completion $<TARGET_FILE:eagerx-gen> 200)
add_test(NAME lsp.neovim COMMAND Python3::Interpreter -B ${CMAKE_CURRENT_LIST_DIR}/neovim $<TARGET_FILE:eagerx-gen>)
set_tests_properties(lsp.neovim PROPERTIES SKIP_RETURN_CODE 77)

# The extension of VS Code, in Node with a module `vscode` of our own.
find_program(eagerx_node NAMES node nodejs)
if(NOT eagerx_node)
  eagerx_left_out(lsp.vscode "there is no Node (toolchains/install-packages tests)")
  return()
endif()
add_test(NAME lsp.vscode COMMAND ${eagerx_node} --test ${CMAKE_CURRENT_LIST_DIR}/vscode/extension.test.cjs)
set_tests_properties(lsp.vscode PROPERTIES ENVIRONMENT EAGERX_BUILD=${PROJECT_BINARY_DIR})
