// The trace: every published message in schedule order, folded into 64 bits. SEMANTICS §11.
#pragma once

#include <bit>
#include <cstdint>
#include <eagerx/message.hpp>
#include <eagerx/rate.hpp>
#include <type_traits>

namespace eagerx {

/// A trace that also wants to see what every callback is given has
/// `static constexpr bool kInputs = true` and
/// `inputs(const char* node, Rate<...> rate, Seq tick, const Inputs& inputs)`, where `rate` is the
/// node's and `inputs.for_each(f)` calls f(name, window) for each. The engine has no inputs and is
/// not among them.
template <class Trace>
inline constexpr bool traces_inputs = requires {
  requires Trace::kInputs;
};

/// A trace that also wants to see the objects has `static constexpr bool kSimulators = true` and
/// `simulator(const char* object, Seq tick, Simulator& simulator)`, which is called at every tick
/// of the engine, before anything reads it; at tick 0 it may set the state that the episode begins
/// in.
template <class Trace>
inline constexpr bool traces_simulators = requires {
  requires Trace::kSimulators;
};

/// A trace that holds slots to real time has `static constexpr bool kSlots = true` and
/// `slot(Rate<...> rate, Seq tick)`, which is called before anything of a slot is calculated, once
/// for every rate that is due; tick/rate is the same for all of them: when the slot should begin.
template <class Trace>
inline constexpr bool waits_for_slots = requires {
  requires Trace::kSlots;
};

/// A trace that can take the engine's place, because it knows what the engine nodes would publish,
/// has `bool runs_engine() const`; while that is false, engine and engine states are not called.
template <class Trace>
constexpr bool runs_engine(const Trace& trace) {
  if constexpr (requires { trace.runs_engine(); }) {
    return trace.runs_engine();
  } else {
    return static_cast<void>(trace), true;
  }
}

/// A trace that hears when somebody wants the run to end has `bool is_interrupted() const`: a reset
/// that waits for something waits no longer, so that the run's end can make a robot safe.
template <class Trace>
constexpr bool is_interrupted(const Trace& trace) {
  if constexpr (requires { trace.is_interrupted(); }) {
    return trace.is_interrupted();
  } else {
    return static_cast<void>(trace), false;
  }
}

/// Costs nothing.
struct NoTrace {
  void episode(std::uint32_t /*index*/) {}
  template <class Message>
  void operator()(std::uint32_t /*channel*/, Seq /*seq*/, const Message& /*message*/) {}
};

/// The bits of a number as the trace sees them: one NaN for all NaNs, integers sign-extended.
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

/// 64-bit hash of all episodes so far. Equal on every target for the same graph, seed and agent.
class HashTrace {
 public:
  void episode(std::uint32_t index) { fold(0x8000000000000000U | index); }
  template <class Message>
  void operator()(std::uint32_t channel, Seq seq, const Message& message) {
    fold((std::uint64_t{channel} << 40U) ^ seq);
    for (std::size_t i = 0; i < size_of<Message>; ++i) fold(canonical_bits(element(message, i)));
  }
  constexpr std::uint64_t hash() const { return folded_ ^ kStart; }

 private:
  static constexpr std::uint64_t kStart = 0xcbf29ce484222325U;
  // Stored xor-ed with the start value, so that the whole program object is zero before its reset.
  void fold(std::uint64_t word) {
    std::uint64_t h = ((folded_ ^ kStart) ^ word) * 0x9e3779b97f4a7c15U;
    h ^= h >> 32U;
    folded_ = h ^ kStart;
  }
  std::uint64_t folded_ = 0;
};

}  // namespace eagerx
