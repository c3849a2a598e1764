# Libraries that are the same for every graph: compiled once and kept.
#
# eagerx_compiled_library(<name> SOURCES <file>... [GENERATED <file>... FROM <file>...] [FOLDERS <folder>...]
#                         [LINK <library>...] [OPTIONS <flag>...] [UNITY] [OF_ITS_TYPE])
#
# <name> is a static library of the sources, and of those that the build generates FROM others. Where EAGERX_LIBRARY_CACHE names a folder, or EAGERX_LIBRARIES one that came
# with the package, and one of them has the library already, it is taken from there; otherwise it is compiled, and the
# cache then has it. What is kept has a folder of its own for each compiler, set of flags, and text of the sources and of
# all headers in FOLDERS, so it is never too old. It is compiled with -O2 for every build type but Debug, so that one serves
# all of them; OF_ITS_TYPE: as the build type says, and for each type anew. What -fcallgraph-info among OPTIONS writes
# (`eagerx-gen size` reads it) is kept with the library. Nothing is kept without either variable. EAGERX_COMPILED lists
# libraries (lib<name>.a) that another build has compiled from these texts, in the same way, a moment ago: the cache gets those.
include_guard(GLOBAL)

function(eagerx_compiled_library name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "UNITY;OF_ITS_TYPE" "" "SOURCES;GENERATED;FROM;FOLDERS;LINK;OPTIONS")
  set(graphs ${CMAKE_CURRENT_BINARY_DIR}/${name}.ci) # of calls, of a library that was taken from where it is kept
  file(REMOVE_RECURSE ${graphs})
  if(EAGERX_LIBRARY_CACHE OR EAGERX_LIBRARIES)
    _eagerx_library_key(key ${name} "${arg_SOURCES};${arg_FROM}" "${arg_FOLDERS}" "${arg_OPTIONS}" ${arg_OF_ITS_TYPE})
    foreach(file IN LISTS EAGERX_COMPILED)
      if(file MATCHES "/lib${name}\\.a$")
        execute_process(COMMAND ${CMAKE_COMMAND} -D FROM=${file} -D TO=${EAGERX_LIBRARY_CACHE}/${key}/lib${name}.a
                                -P ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/keep_library.cmake)
      endif()
    endforeach()
    foreach(folder IN LISTS EAGERX_LIBRARIES EAGERX_LIBRARY_CACHE)
      set(kept ${folder}/${key}/lib${name}.a)
      set(is_whole FALSE)
      if(NOT folder STREQUAL EAGERX_LIBRARY_CACHE)
        if(EXISTS ${kept}) # a package's, which may have been stripped, and whose files it knows
          set(is_whole TRUE)
        endif()
      else()
        _eagerx_is_whole(is_whole ${kept})
      endif()
      if(is_whole)
        add_library(${name} STATIC IMPORTED GLOBAL)
        set_target_properties(${name} PROPERTIES IMPORTED_LOCATION ${kept})
        target_link_libraries(${name} INTERFACE ${arg_LINK})
        if(arg_OPTIONS MATCHES "-fcallgraph-info")
          file(GLOB kept ${folder}/${key}/*.ci)
          file(COPY ${kept} DESTINATION ${graphs})
        endif()
        return()
      endif()
    endforeach()
  endif()
  add_library(${name} STATIC EXCLUDE_FROM_ALL ${arg_SOURCES} ${arg_GENERATED})
  target_link_libraries(${name} PUBLIC ${arg_LINK})
  set(level $<$<NOT:$<CONFIG:Debug>>:-O2>)
  if(arg_OF_ITS_TYPE)
    set(level)
  endif()
  target_compile_options(${name} PRIVATE ${arg_OPTIONS} ${level})
  if(arg_UNITY)
    # The headers of the standard library take most of the time: once for all files. tests/lint compiles each by itself.
    set(unity ON)
    if(DEFINED EAGERX_UNITY)
      set(unity ${EAGERX_UNITY})
    endif()
    set_target_properties(${name} PROPERTIES UNITY_BUILD ${unity} UNITY_BUILD_BATCH_SIZE 0)
  endif()
  if(EAGERX_LIBRARY_CACHE)
    # A cache that cannot be written costs time and nothing else.
    add_custom_command(
      TARGET ${name} POST_BUILD
      COMMAND ${CMAKE_COMMAND} -D FROM=$<TARGET_FILE:${name}> -D TO=${EAGERX_LIBRARY_CACHE}/${key}/lib${name}.a
              "-D OBJECTS=$<TARGET_OBJECTS:${name}>" -P ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/keep_library.cmake
      VERBATIM)
  endif()
endfunction()

# Whether a library that was kept is as it was written. What changes it configures anew.
function(_eagerx_is_whole variable kept)
  set(${variable} FALSE PARENT_SCOPE)
  if(EXISTS ${kept} AND EXISTS ${kept}.sha256)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${kept})
    file(SHA256 ${kept} found)
    file(READ ${kept}.sha256 sum)
    if(found STREQUAL sum)
      set(${variable} TRUE PARENT_SCOPE)
    endif()
  endif()
endfunction()

# Makes the key of a compiled library from everything that affects its contents. A change of a file reconfigures.
function(_eagerx_library_key variable name sources folders options of_its_type)
  set(type)
  if(of_its_type OR CMAKE_BUILD_TYPE STREQUAL Debug)
    string(TOUPPER "${CMAKE_BUILD_TYPE}" capitals)
    set(type "${CMAKE_BUILD_TYPE} ${CMAKE_CXX_FLAGS_${capitals}}")
  endif()
  set(text "${name} ${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION} ${CMAKE_CXX_COMPILER_ARCHITECTURE_ID} \
${CMAKE_LIBRARY_ARCHITECTURE} ${CMAKE_SYSTEM_NAME} ${CMAKE_SYSTEM_PROCESSOR} ${CMAKE_CXX_FLAGS} ${type} \
${CMAKE_POSITION_INDEPENDENT_CODE} ${CMAKE_INTERPROCEDURAL_OPTIMIZATION} ${options}")
  get_target_property(flags eagerx::runtime INTERFACE_COMPILE_OPTIONS)
  string(APPEND text " ${flags}")
  set(files ${sources})
  foreach(folder IN LISTS folders)
    file(GLOB_RECURSE headers ${folder}/*.hpp ${folder}/*.h)
    list(APPEND files ${headers})
  endforeach()
  get_property(known DIRECTORY PROPERTY CMAKE_CONFIGURE_DEPENDS)
  foreach(file IN LISTS files)
    cmake_path(NORMAL_PATH file)
    list(APPEND known ${file})
    file(SHA256 ${file} hash)
    string(APPEND text " ${hash}")
  endforeach()
  list(REMOVE_DUPLICATES known)
  set_property(DIRECTORY PROPERTY CMAKE_CONFIGURE_DEPENDS ${known})
  string(SHA256 key "${text}")
  string(SUBSTRING ${key} 0 16 key)
  set(${variable} ${key} PARENT_SCOPE)
endfunction()
