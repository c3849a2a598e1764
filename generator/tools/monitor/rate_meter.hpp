// Measures the rate of events.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace eagerx::gen {

/// Times are of one clock, in nanoseconds, and do not go back.
class RateMeter {
 public:
  void add(std::int64_t at_ns);
  /// The rate in the last two seconds; for rarer events, from the last two times. nullopt before
  /// two events. After the last event, the rate falls gradually.
  [[nodiscard]] std::optional<double> hz(std::int64_t now_ns) const;

 private:
  static constexpr std::int64_t kPartNs = 250'000'000;
  static constexpr std::size_t kParts = 8;

  struct Part {
    std::int64_t number = -1;  // of the part of time
    std::int64_t first_ns = 0, last_ns = 0;
    std::uint64_t count = 0;
  };

  std::array<Part, kParts> parts_;
  std::int64_t last_ns_ = 0, before_last_ns_ = 0;
  std::uint64_t count_ = 0;
};

}  // namespace eagerx::gen
