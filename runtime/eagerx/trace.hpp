// The trace: every published message in schedule order, folded into 64 bits. SEMANTICS §11.
#pragma once

#include <bit>
#include <cstdint>
#include <eagerx/message.hpp>
#include <eagerx/rate.hpp>
#include <type_traits>

namespace eagerx {

/// The bits of a number in the trace: the same NaN for all NaNs, integers sign-extended.
template <class T>
constexpr std::uint64_t canonical_bits(T value) {
  if constexpr (std::is_floating_point_v<T>) {
    using Bits = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;
    constexpr Bits kNan =
        sizeof(T) == 4 ? Bits{0x7fc00000U} : static_cast<Bits>(0x7ff8000000000000U);
    return value != value ? kNan : std::bit_cast<Bits>(value);
  } else {
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(value));
  }
}

/// Hooks of a program (hooks.hpp) that compute a 64-bit hash of all episodes so far, equal on every
/// target for the same graph, seed and agent.
class HashTrace {
 public:
  void on_episode(std::uint32_t index) { fold(0x8000000000000000U | index); }
  template <class Message>
  void on_message(std::uint32_t channel, Seq seq, const Message& message) {
    fold((std::uint64_t{channel} << 40U) ^ seq);
    for (std::size_t i = 0; i < size_of<Message>; ++i) fold(canonical_bits(element(message, i)));
  }
  constexpr std::uint64_t hash() const { return folded_ ^ kStart; }

 private:
  static constexpr std::uint64_t kStart = 0xcbf29ce484222325U;
  // Stored xor'ed with the start value, so that the whole program object is zero before its reset.
  void fold(std::uint64_t word) {
    std::uint64_t h = ((folded_ ^ kStart) ^ word) * 0x9e3779b97f4a7c15U;
    h ^= h >> 32U;
    folded_ = h ^ kStart;
  }
  std::uint64_t folded_ = 0;
};

}  // namespace eagerx
