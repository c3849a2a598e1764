// A node of a user: what a class may use of its Io and of the runtime.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/math.hpp>
#include <eagerx/message.hpp>
#include <eagerx/rate.hpp>

namespace own {

template <class Io>
class Gain {
 public:
  void reset(const typename Io::States& states) {
    offset_ = Real(0);
    if (states.offset) offset_ = static_cast<Real>(*states.offset);
  }

  void callback(const eagerx::Tick& tick, const typename Io::Inputs& in,
                typename Io::Outputs& out) {
    using Message = typename decltype(Io::Inputs::signal)::value_type;
    constexpr auto kGain = static_cast<Real>(Io::Config::gain);
    constexpr auto kLimit = static_cast<Real>(Io::Config::limit);
    ticks_ = tick.n;
    const Message signal = in.signal.empty() ? Message{} : in.signal.back();
    for (std::size_t i = 0; i < eagerx::size_of<Message>; ++i) {
      const Real scaled = kGain * static_cast<Real>(eagerx::element(signal, i)) + offset_;
      const Real limited = eagerx::max(-kLimit, eagerx::min(scaled, kLimit));
      if (limited != scaled) ++limited_;
      eagerx::element(out.limited, i) = static_cast<eagerx::ScalarOf<Message>>(limited);
    }
  }

  template <class F>
  void for_each_count(F&& f) const {
    f("limited", limited_);
  }

 private:
  using Real = typename Io::Real;

  Real offset_;
  eagerx::Seq ticks_;
  std::uint64_t limited_;
};

}  // namespace own
