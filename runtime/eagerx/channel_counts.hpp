// Counts of something that happens to channels: actions, observations.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace eagerx {

/// Calls f("what: name", count). The text is valid during the call, and cut off after 127
/// characters.
template <class F>
void tell_count(F&& f, const char* what, const char* name, std::uint64_t count) {
  constexpr std::size_t kLongest = 127;
  char text[kLongest + 1];
  std::size_t n = 0;
  for (const char* part : {what, ": ", name}) {
    while (*part != '\0' && n < kLongest) text[n++] = *part++;
  }
  text[n] = '\0';
  f(static_cast<const char*>(text), count);
}

/// One count for each of `N` channels, initially zero.
template <std::size_t N>
class ChannelCounts {
 public:
  void add(std::size_t channel) { ++counts_[channel]; }
  std::uint32_t& operator[](std::size_t channel) { return counts_[channel]; }
  std::uint32_t operator[](std::size_t channel) const { return counts_[channel]; }

  /// f("what: name", count) for each channel.
  template <class F>
  void for_each(F&& f, const char* what, const std::array<const char*, N>& names) const {
    for (std::size_t i = 0; i < N; ++i) tell_count(f, what, names[i], counts_[i]);
  }

 private:
  std::array<std::uint32_t, N> counts_{};
};

}  // namespace eagerx
