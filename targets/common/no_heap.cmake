# The proof that a program never uses a heap, exceptions or guarded statics: every way into them is renamed to
# __wrap_<name>, which nobody defines, so that one use anywhere fails the link with that name.
function(eagerx_forbid_heap executable)
  set(names
      malloc free calloc realloc memalign aligned_alloc posix_memalign
      _malloc_r _free_r _calloc_r _realloc_r _memalign_r _sbrk _sbrk_r
      _Znwj _Znaj _ZnwjSt11align_val_t _ZnajSt11align_val_t # operator new, new[]
      _ZdlPv _ZdaPv _ZdlPvj _ZdaPvj _ZdlPvSt11align_val_t _ZdlPvjSt11align_val_t # operator delete, delete[]
      __cxa_throw __cxa_allocate_exception __cxa_guard_acquire)
  list(TRANSFORM names PREPEND "-Wl,--wrap=")
  target_link_options(${executable} PRIVATE ${names})
endfunction()
