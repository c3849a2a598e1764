// Injected faults: their kinds, their frequency, and how many were injected.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace eagerx::emulated {

enum class Fault : std::uint8_t {
  unplug,     // the adapter is pulled out, before or after it has taken the commands
  cut,        // the answer ends early, the rest never comes
  silent,     // no answer at all
  late,       // the answer comes after the program has given up
  split,      // the answer comes in two pieces: harmless
  spike,      // the answer takes some milliseconds more: harmless
  corrupt,    // one bit of the encoder's answer is wrong
  stuck_low,  // the data line from the devices is stuck at 0
  stuck_high,
  nak,        // I2C: a byte is not acknowledged
  oversleep,  // the program is woken up 40 to 80 ms late
};
inline constexpr std::size_t kFaults = 11;
inline constexpr std::array<const char*, kFaults> kFaultNames = {
    "unplug",  "cut",       "silent",     "late", "split",    "spike",
    "corrupt", "stuck_low", "stuck_high", "nak",  "oversleep"};

/// Samples faults, at most one for each batch of transfers that has an answer and one for each
/// sleep.
class Faults {
 public:
  Faults() = default;

  /// Each of the allowed kinds has the same part of `probability`; at most `most` happen.
  void configure(std::uint64_t seed, double probability, std::uint32_t kinds, std::uint64_t most);

  /// Whether a batch gets a fault, and which. Not oversleep, and nak only with I2C in the batch.
  bool sample(Fault& fault, bool has_i2c);
  /// How much longer a sleep takes.
  std::int64_t oversleep_ns();

  /// Uniform in [low, high].
  std::int64_t between(std::int64_t low, std::int64_t high);
  std::uint64_t count(Fault fault) const { return counts_[static_cast<std::size_t>(fault)]; }
  /// The next batch gets this fault.
  void force(Fault fault) {
    forced_ = fault;
    is_forced_ = true;
  }

 private:
  std::uint64_t next();
  bool allowed(Fault fault) const { return (kinds_ >> static_cast<unsigned>(fault) & 1U) != 0; }
  void note(Fault fault);

  std::uint64_t state_ = 1;
  double probability_ = 0.0;
  std::uint32_t kinds_ = 0;
  std::uint64_t left_ = 0;
  Fault forced_ = Fault::unplug;
  bool is_forced_ = false;
  std::array<std::uint64_t, kFaults> counts_{};
};

}  // namespace eagerx::emulated
