// Checks of a call before it has an effect.
#pragma once

#include <targets/environments/eagerx_environments.h>

#include <cfenv>
#include <cstddef>
#include <cstdint>

namespace eagerx::environments {

/// A program may have set the processor to flush denormals to zero or to round differently, so bits
/// would differ: sets the right mode during a call, and restores the program's mode afterwards.
/// Throws Problem.
class RightFloats {
 public:
  RightFloats() {
    if (!says_so()) set_right();
  }
  RightFloats(const RightFloats&) = delete;
  RightFloats& operator=(const RightFloats&) = delete;
  ~RightFloats() {
    if (changed_) std::fesetenv(&callers_);
  }

 private:
  /// The processor's own flags, in a tenth of the time that it takes to calculate: neither
  /// the bits of denormal numbers nor those of rounding are set.
  static bool says_so() {
#if defined(__SSE2__) && defined(__x86_64__)
    constexpr unsigned kOtherwise = 0xe040U;
    return (__builtin_ia32_stmxcsr() & kOtherwise) == 0;
#else
    return false;
#endif
  }
  void set_right();

  std::fenv_t callers_;  // if changed
  bool changed_ = false;
};

/// Each throws Problem.
void check_options(const eagerx_options* options);
[[noreturn]] void refuse_size(const char* name, std::size_t given, std::size_t wanted);
inline void check_size(const char* name, std::size_t given, std::size_t wanted) {
  if (given != wanted) refuse_size(name, given, wanted);
}
/// Of a picture, in pixels, 1 to `most`.
void check_side(const char* name, std::uint32_t pixels, std::uint32_t most);
/// One of `size` environments.
void check_number(std::uint32_t environment, std::uint32_t size);
/// Rows of this number of numbers.
void check_rows(const char* name, const void* rows, std::size_t numbers);

}  // namespace eagerx::environments
