// Indexes of messages and windows. With EAGERX_CHECKS, which debug builds and sanitizers define,
// each index is checked, and an index out of range ends the program with its place in the node's
// source.
#pragma once

#ifdef EAGERX_CONSTANT_INDEXES  // defined by `eagerx-gen check --compile`

#include <cstddef>

namespace eagerx {

/// Never defined: the compiler warns about each remaining call.
[[gnu::warning("index is outside of the message")]] void index_is_outside();

/// An index. If the compiler knows its value, it must be below Size.
template <std::size_t Size>
[[gnu::always_inline]] constexpr std::size_t known_below(std::size_t i) {
  if (__builtin_constant_p(i) && i >= Size) index_is_outside();
  return i;
}

}  // namespace eagerx

#elif defined(EAGERX_CHECKS)

#include <cstddef>
#include <cstdint>
#include <source_location>
#include <version>

/// Reports the index and ends the program. On Linux, runtime/host/base defines it.
extern "C" [[gnu::weak]] void eagerx_index_is_outside(const char* file, std::uint_least32_t line,
                                                      const char* function, const char* of,
                                                      std::size_t index, std::size_t size);

namespace eagerx {

#ifdef __cpp_lib_source_location
using SourcePlace = std::source_location;
#else  // Clang 14 has the builtin functions, but not the one that libstdc++ asks for
class SourcePlace {
 public:
  static constexpr SourcePlace current(const char* file = __builtin_FILE(),
                                       std::uint_least32_t line = __builtin_LINE(),
                                       const char* function = __builtin_FUNCTION()) {
    SourcePlace result;
    result.file_ = file;
    result.line_ = line;
    result.function_ = function;
    return result;
  }
  constexpr const char* file_name() const { return file_; }
  constexpr std::uint_least32_t line() const { return line_; }
  constexpr const char* function_name() const { return function_; }

 private:
  const char* file_ = "";
  std::uint_least32_t line_ = 0;
  const char* function_ = "";
};
#endif

/// A number, and the place in the source where it became an index.
class Index {
 public:
  // Not explicit, so that `message[i]` compiles.
  constexpr Index(  // NOLINT(google-explicit-constructor)
      std::size_t value, SourcePlace place = SourcePlace::current())
      : value_(value), place_(place) {}

  /// `of`: what is indexed, "message" or "window", with `size` elements.
  constexpr std::size_t below(std::size_t size, const char* of) const {
    if (value_ < size) return value_;
    if (eagerx_index_is_outside != nullptr)
      eagerx_index_is_outside(place_.file_name(), place_.line(), place_.function_name(), of, value_,
                              size);
    __builtin_trap();
  }

 private:
  std::size_t value_;
  SourcePlace place_;
};

}  // namespace eagerx

#endif
