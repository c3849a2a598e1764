# cmake -DNM=… -DIMAGE=… -P check_symbols.cmake
# Fails, and removes the image, if its symbol table has something of a heap, exceptions, type information or
# guards of static variables.
execute_process(COMMAND ${NM} ${IMAGE} OUTPUT_VARIABLE table RESULT_VARIABLE failed)
if(failed)
  message(FATAL_ERROR "cannot read the symbols of ${IMAGE}")
endif()
set(heap "(__wrap_)?(malloc|free|calloc|realloc|sbrk|_sbrk|_(malloc|free|calloc|realloc|sbrk)_r|_Zn[wa]j.*|_Zd[la]Pv.*)")
set(exceptions "__cxa_(throw|rethrow|allocate_exception|begin_catch|end_catch)|_Unwind_[A-Z].*|__gxx_personality.*")
set(types "_ZT[IS].*|_ZTVN10__cxxabiv1.*|__dynamic_cast")
set(guards "_ZGV.*|__cxa_guard_.*")
foreach(kind heap exceptions types guards)
  string(REGEX MATCHALL "[0-9a-f ]+ [A-Za-z] (${${kind}})\n" found "${table}")
  if(found)
    string(REGEX REPLACE "[0-9a-f ]+ [A-Za-z] ([^\n]*)\n;?" " `\\1`" names "${found}")
    file(REMOVE ${IMAGE})
    message(FATAL_ERROR "${IMAGE} must not have ${kind}, but has${names}")
  endif()
endforeach()
