# cmake -DFOLDER=<generated sources> -DSTAMP=<file> -P EagerxLibraries.cmake
#
# Writes <file>.cflags and <file>.libs, which compiler and linker read: how to use the libraries that the generated
# CMakeLists.txt lists. eagerx_add_graph() runs it after the generator, when a graph and its engine are known.
if(NOT EXISTS ${FOLDER}/CMakeLists.txt)
  message(FATAL_ERROR "there is no program in ${FOLDER}: of a graph with `placement:` name all parts again, as SPLIT of "
                      "eagerx_add_graph()")
endif()
file(STRINGS ${FOLDER}/CMakeLists.txt line REGEX "^set\\(EAGERX_PACKAGES ")
string(REGEX REPLACE "^set\\(EAGERX_PACKAGES (.*)\\)$" "\\1" packages "${line}")
separate_arguments(packages UNIX_COMMAND "${packages}")
foreach(kind cflags libs)
  set(flags "")
  if(packages)
    execute_process(
      COMMAND pkg-config --${kind} ${packages}
      OUTPUT_VARIABLE flags ERROR_VARIABLE problem RESULT_VARIABLE result)
    if(NOT result EQUAL 0)
      message(FATAL_ERROR "the graph needs ${packages}, but pkg-config says: ${problem}")
    endif()
  endif()
  file(WRITE ${STAMP}.${kind} "${flags}\n")
endforeach()
