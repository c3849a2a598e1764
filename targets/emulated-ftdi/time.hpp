// Time as the program sees it: the machine's, or emulated.
#pragma once

#include <cstdint>

namespace eagerx::emulated {

inline constexpr std::int64_t kNsPerUs = 1'000;
inline constexpr std::int64_t kNsPerMs = 1'000'000;
inline constexpr std::int64_t kNsPerSecond = 1'000'000'000;

/// Emulated time advances only by transfers, sleeps, and a little for every read of the clock. So a
/// run repeats exactly on a slow or busy machine.
class Time {
 public:
  explicit Time(bool emulated) : emulated_(emulated) {}

  bool emulated() const { return emulated_; }
  std::int64_t now_ns() const;
  /// The program looks at the clock.
  std::int64_t look();
  /// Something takes `ns`.
  void pass(std::int64_t ns) { wait_until(now_ns() + ns); }
  void wait_until(std::int64_t ns);

 private:
  bool emulated_;
  std::int64_t now_ns_ = kNsPerSecond;
};

}  // namespace eagerx::emulated
