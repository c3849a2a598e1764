// Functions of libraries that a program opens at run time, so that it also runs without them.
#pragma once

#include <dlfcn.h>

namespace eagerx {

/// The function `name` of a library that dlopen() gave, into `function`. False: it has none.
template <class F>
bool look_up(void* library, const char* name, F& function) {
  function = reinterpret_cast<F>(dlsym(library, name));
  return function != nullptr;
}

}  // namespace eagerx
