# cmake -DFOLDER=<generated sources> -DSTAMP=<file> -P EagerxLibraries.cmake
#
# Writes <file>.cflags and <file>.libs, which compiler and linker read: how to use the libraries that the generated
# CMakeLists.txt lists, and a macro with the name of a library. eagerx_add_graph() runs it after the generator, when a graph and its engine are known.
if(NOT EXISTS ${FOLDER}/CMakeLists.txt)
  message(FATAL_ERROR "there is no program in ${FOLDER}: of a graph with `placement:` name all parts again, as SPLIT of "
                      "eagerx_add_graph()")
endif()
file(STRINGS ${FOLDER}/CMakeLists.txt line REGEX "^set\\(EAGERX_PACKAGES ")
string(REGEX REPLACE "^set\\(EAGERX_PACKAGES (.*)\\)$" "\\1" packages "${line}")
separate_arguments(packages UNIX_COMMAND "${packages}")

# Of two graphs of one name in a program, such as two variants, every file would include the one whose folder is searched
# first. The compiler says so: this macro has two values then.
set(one_graph "")
file(GLOB header RELATIVE ${FOLDER} ${FOLDER}/*.hpp) # a library has one there, a program none
if(header)
  string(REGEX REPLACE "\\.hpp$" "" name ${header})
  set(text "")
  file(GLOB_RECURSE files ${FOLDER}/*.hpp)
  foreach(file IN LISTS files)
    file(SHA256 ${file} hash)
    string(APPEND text ${hash})
  endforeach()
  string(SHA256 hash "${text}")
  string(SUBSTRING ${hash} 0 8 hash)
  set(one_graph " -DEAGERX_ONLY_ONE_GRAPH_OF_A_PROGRAM_IS_NAMED_${name}=0x${hash}")
endif()

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
  if(kind STREQUAL cflags)
    string(APPEND flags "${one_graph}")
  endif()
  file(WRITE ${STAMP}.${kind} "${flags}\n")
endforeach()
