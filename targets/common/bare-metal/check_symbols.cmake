# cmake -DNM=… -DIMAGE=… -P check_symbols.cmake
# Fails, and removes the image, if its symbol table has something of a heap, exceptions, type information or
# guards of static variables.
execute_process(COMMAND ${NM} ${IMAGE} OUTPUT_VARIABLE table RESULT_VARIABLE failed)
if(failed)
  message(FATAL_ERROR "cannot read the symbols of ${IMAGE}")
endif()
# Placement new and delete (_ZnwjPv, _ZdlPvS_) allocate nothing; without inlining they are functions.
set(new "_Zn[wa]j([^P\n][^\n]*)?")
set(delete "_Zd[la]Pv([^S\n][^\n]*|St[^\n]*)?")
set(heap "(__wrap_)?(malloc|free|calloc|realloc|sbrk|_sbrk|_(malloc|free|calloc|realloc|sbrk)_r|${new}|${delete})")
set(exceptions "__cxa_(throw|rethrow|allocate_exception|begin_catch|end_catch)|_Unwind_[A-Z][^\n]*|__gxx_personality[^\n]*")
set(types "_ZT[IS][^\n]*|_ZTVN10__cxxabiv1[^\n]*|__dynamic_cast")
set(guards "_ZGV[^\n]*|__cxa_guard_[^\n]*")
foreach(kind heap exceptions types guards)
  string(REGEX MATCHALL "[0-9a-f ]+ [A-Za-z] (${${kind}})\n" found "${table}")
  if(found)
    string(REGEX REPLACE "[0-9a-f ]+ [A-Za-z] ([^\n]*)\n;?" " `\\1`" names "${found}")
    file(REMOVE ${IMAGE})
    message(FATAL_ERROR "${IMAGE} must not have ${kind}, but has${names}")
  endif()
endforeach()
