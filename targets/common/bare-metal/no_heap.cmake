# The proof that a program never uses a heap, exceptions, type information or guarded statics. In two parts:
# every way into a heap or an exception is renamed to __wrap_<name>, which is not defined, so that one use
# anywhere fails the link with that name; what the compiler may put in besides is looked for in the symbols of the
# image.
function(eagerx_forbid_heap executable)
  set(names
      malloc free calloc realloc memalign aligned_alloc posix_memalign reallocarray sbrk
      _malloc_r _free_r _calloc_r _realloc_r _memalign_r _sbrk _sbrk_r
      _Znwj _Znaj _ZnwjSt11align_val_t _ZnajSt11align_val_t # operator new, new[]
      _ZnwjRKSt9nothrow_t _ZnajRKSt9nothrow_t
      _ZdlPv _ZdaPv _ZdlPvj _ZdaPvj _ZdlPvSt11align_val_t _ZdlPvjSt11align_val_t # operator delete, delete[]
      __cxa_throw __cxa_allocate_exception __cxa_guard_acquire __dynamic_cast)
  list(TRANSFORM names PREPEND "-Wl,--wrap=")
  target_link_options(${executable} PRIVATE ${names})
  add_custom_command(
    TARGET ${executable}
    POST_BUILD
    COMMAND ${CMAKE_COMMAND} -DNM=${CMAKE_NM} -DIMAGE=$<TARGET_FILE:${executable}> -P
            ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/check_symbols.cmake
    VERBATIM)
endfunction()
