// The arithmetic of the integer entities: every message that a callback gets changes everything it
// sends from then on. The same as in the recordings of EAGERx that these entities come from.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/message.hpp>
#include <eagerx/rate.hpp>

namespace oracle {

inline constexpr std::int64_t kModulus = 1000003;
inline constexpr std::int64_t kBase = 131;

using Message = eagerx::Array<std::int64_t, 2>;  // id, checksum

/// The checksum `h` after all inputs, in their order. Of the engine's ticks only the number counts.
template <class Inputs>
constexpr std::int64_t fold(const Inputs& inputs, std::int64_t h) {
  inputs.for_each([&](const char* /*name*/, const auto& window) {
    h = (h * kBase + window.size() + 1) % kModulus;
    if constexpr (requires { window[0][1]; }) {
      constexpr std::int64_t kIdFactor = 7;
      for (std::uint32_t i = 0; i < window.size(); ++i) {
        h = (h * kBase + window[i][0] * kIdFactor + window[i][1]) % kModulus;
      }
    }
  });
  return h;
}

/// The message of output `index` of a node: `count` callbacks have run before this one.
constexpr Message message(std::int64_t nid, std::int64_t count, std::int64_t h,
                          std::int64_t index) {
  constexpr std::int64_t kIds = 100000;
  constexpr std::int64_t kFactor = 31;
  return {{nid * kIds + count, (h * kFactor + index) % kModulus}};
}

/// Sends on those of the outputs o0, o1 and o2 that are used.
template <class Outputs>
constexpr void send(Outputs& out, std::int64_t nid, std::int64_t count, std::int64_t h) {
  std::int64_t index = 0;
  if constexpr (requires { out.o0; }) out.o0 = message(nid, count, h, index++);
  if constexpr (requires { out.o1; }) out.o1 = message(nid, count, h, index++);
  if constexpr (requires { out.o2; }) out.o2 = message(nid, count, h, index++);
}
template <class Outputs>
constexpr void send(Outputs& out, std::int64_t nid, const eagerx::Tick& tick, std::int64_t h) {
  send(out, nid, static_cast<std::int64_t>(tick.n), h);
}

}  // namespace oracle
