# Makes `library` a shared library for the machine that builds it. Only eagerx_* can be seen in it, so that one process
# can load the libraries of several graphs.
set(EAGERX_TARGET_MAKES SHARED_LIBRARY)

function(eagerx_configure_target library)
  include(${CMAKE_CURRENT_FUNCTION_LIST_DIR}/libraries.cmake)
  eagerx_environments_libraries()
  target_link_libraries(${library} PRIVATE eagerx_environments)
  _eagerx_add_simd(${library})
  # No other library may replace one of these functions.
  target_compile_options(${library} PRIVATE -fvisibility-inlines-hidden $<$<CXX_COMPILER_ID:GNU>:-fno-semantic-interposition>)
  # Without a build type CMake would not optimise at all.
  target_compile_options(${library} PRIVATE -Wall -Wextra $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict> $<$<CONFIG:>:-O2>)
  target_compile_definitions(${library} PRIVATE $<$<CONFIG:Debug>:EAGERX_CHECKS>)
  set(visible ${CMAKE_CURRENT_BINARY_DIR}/eagerx_environments.map)
  set(functions version describe error create destroy reset step act set_states tune get_states get_exact_states set_stage critic trace hash counts
                picture stepping)
  list(TRANSFORM functions PREPEND "eagerx_")
  file(CONFIGURE OUTPUT ${visible} CONTENT "{ global: @functions@; local: *; };\n" @ONLY)
  target_link_options(${library} PRIVATE -Wl,--version-script=${visible} -Wl,--no-undefined)
  set_target_properties(${library} PROPERTIES OUTPUT_NAME ${library}_environments LINK_DEPENDS ${visible})
endfunction()

# The instruction sets above plain x86-64 that a library is vectorized for: EAGERX_INSTRUCTION_SETS, a list of them, or
# `native`: those of the processor that builds. Both without it, so that a library can go to other machines.
function(_eagerx_x86_simd result)
  set(known avx2 avx512)
  set(chosen ${known})
  if(EAGERX_INSTRUCTION_SETS STREQUAL native)
    set(chosen)
    file(STRINGS /proc/cpuinfo flags REGEX "^flags" LIMIT_COUNT 1)
    if("${flags} " MATCHES " avx2 ")
      list(APPEND chosen avx2)
    endif()
    if("${flags} " MATCHES " avx512f .*avx512dq .*avx512bw .*avx512vl ")
      list(APPEND chosen avx512)
    endif()
  elseif(DEFINED EAGERX_INSTRUCTION_SETS)
    set(chosen ${EAGERX_INSTRUCTION_SETS})
    list(REMOVE_ITEM chosen plain)
    foreach(kind IN LISTS chosen)
      if(NOT kind IN_LIST known)
        message(FATAL_ERROR "EAGERX_INSTRUCTION_SETS: there is no `${kind}`, but plain, avx2, avx512 and native")
      endif()
    endforeach()
  endif()
  set(${result} ${chosen} PARENT_SCOPE)
endfunction()

# Vectorized environments: main.cpp once more for each instruction set, of which the library chooses one when it runs.
# Inline functions that several of these objects have would become one, and the linker could take the one that has
# instructions which the processor lacks. So nothing can be seen of such an object but the one function that gives the
# others: `ld -r` ends its groups of functions that are the same elsewhere, objcopy hides them.
function(_eagerx_add_simd library)
  get_target_property(sources ${library} SOURCES)
  set(kinds plain)
  target_compile_definitions(${library} PRIVATE EAGERX_WITH_SIMD)
  if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64" AND CMAKE_OBJCOPY AND CMAKE_LINKER AND CMAKE_SIZEOF_VOID_P EQUAL 8)
    _eagerx_x86_simd(wider)
    foreach(kind IN LISTS wider)
      list(APPEND kinds ${kind})
      string(TOUPPER ${kind} name)
      target_compile_definitions(${library} PRIVATE EAGERX_WITH_${name}_SIMD)
    endforeach()
  endif()
  # GCC leaves functions on SIMD vectors out of line that it would inline for plain numbers.
  set(inline_flags -fno-gnu-unique)
  foreach(limit max-inline-insns-single=3000 max-inline-insns-auto=3000 large-function-growth=3000 inline-unit-growth=1000
                large-stack-frame=100000 large-stack-frame-growth=10000)
    list(APPEND inline_flags --param=${limit})
  endforeach()
  set(flags_avx2 -mavx2)
  set(flags_avx512 -mavx512f -mavx512bw -mavx512dq -mavx512vl)
  # The sources are made once, however many targets wait for them.
  set(stamps ${sources})
  list(FILTER stamps INCLUDE REGEX "\\.stamp$")
  add_custom_target(${library}.sources DEPENDS ${stamps})
  add_dependencies(${library} ${library}.sources)
  foreach(kind IN LISTS kinds)
    set(object ${library}.simd_${kind})
    add_library(${object} OBJECT EXCLUDE_FROM_ALL ${sources})
    add_dependencies(${object} ${library}.sources)
    set_target_properties(${object} PROPERTIES POSITION_INDEPENDENT_CODE ON)
    target_compile_definitions(${object} PRIVATE EAGERX_SIMD=eagerx_simd_${kind})
    target_include_directories(${object} PRIVATE $<TARGET_PROPERTY:${library},INCLUDE_DIRECTORIES>)
    target_link_libraries(${object} PRIVATE eagerx::runtime)
    # Vectors are passed between functions of the object alone.
    target_compile_options(${object} PRIVATE -Wall -Wextra -Wno-psabi -fno-exceptions -fno-rtti ${flags_${kind}})
    # Loops over registers are only registers once they are unrolled and in one function: -O2 makes half of the speed.
    # EAGERX_SIMD_LEVEL is for those who look at bits alone.
    set(level -O3)
    if(DEFINED EAGERX_SIMD_LEVEL)
      set(level ${EAGERX_SIMD_LEVEL})
    endif()
    target_compile_options(${object} PRIVATE $<$<NOT:$<CONFIG:Debug>>:${level}> $<$<CXX_COMPILER_ID:GNU>:${inline_flags}>)
    set(hidden ${CMAKE_CURRENT_BINARY_DIR}/${object}.o)
    if(kind STREQUAL plain)
      target_link_libraries(${library} PRIVATE $<TARGET_OBJECTS:${object}>)
      add_dependencies(${library} ${object})
    else()
      add_custom_command(
        OUTPUT ${hidden}
        COMMAND ${CMAKE_LINKER} -r --force-group-allocation -o ${hidden}.whole $<TARGET_OBJECTS:${object}>
        COMMAND ${CMAKE_OBJCOPY} --keep-global-symbol=eagerx_simd_${kind} ${hidden}.whole ${hidden}
        DEPENDS ${object} $<TARGET_OBJECTS:${object}>
        COMMAND_EXPAND_LISTS VERBATIM)
      set_source_files_properties(${hidden} PROPERTIES EXTERNAL_OBJECT TRUE GENERATED TRUE)
      target_sources(${library} PRIVATE ${hidden})
    endif()
  endforeach()
endfunction()
