// What eagerx/index.hpp calls.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <runtime/host/base/interrupt.hpp>
#include <string>

extern "C" [[noreturn]] void eagerx_index_is_outside(const char* file, std::uint_least32_t line,
                                                     const char* function, const char* of,
                                                     std::size_t index, std::size_t size) {
  const std::string place = std::filesystem::path(file).lexically_normal().string();
  std::fprintf(stderr, "%s:%lu: error: index %zu of a %s with %zu %s\n  in %s\n", place.c_str(),
               static_cast<unsigned long>(line), index, of, size,
               size == 1 ? "element" : "elements", function);
  eagerx::host::make_safe_now();
  std::abort();
}
