// A fault to try safety with.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/message.hpp>
#include <eagerx/rate.hpp>
#include <limits>

namespace examples {

enum class Break : std::uint8_t { none, not_a_number, rattle };

/// broken := the last signal, but in the ticks [begin, end) NaN or ±size in turn.
template <class Io>
class BrokenPolicy {
 public:
  void reset(const typename Io::States& /*states*/) {}

  void callback(const eagerx::Tick& tick, const typename Io::Inputs& in,
                typename Io::Outputs& out) {
    using Config = typename Io::Config;
    using Message = typename decltype(Io::Inputs::signal)::value_type;
    using Scalar = eagerx::ScalarOf<Message>;
    out.broken = in.signal.empty() ? Message{} : in.signal.back();
    const bool breaks = tick.n >= static_cast<eagerx::Seq>(Config::begin) &&
                        tick.n < static_cast<eagerx::Seq>(Config::end);
    if (!breaks || Config::kind == Break::none) return;
    const auto size = static_cast<Scalar>(Config::size);
    const Scalar rattle = (tick.n & 1U) != 0 ? -size : size;
    const Scalar value =
        Config::kind == Break::not_a_number ? std::numeric_limits<Scalar>::quiet_NaN() : rattle;
    out.broken = eagerx::filled<Message>(value);
  }
};

}  // namespace examples
