// The reset node of the exercise of tutorial 8. Not finished.
#pragma once

#include <eagerx/random.hpp>
#include <eagerx/rate.hpp>

namespace tutorial {

/// During a reset, every tick: a random u [V]; done more than `seconds` after the first call.
template <class Io>
class RandomActions {
 public:
  void reset(const typename Io::States& states) {
    running_ = false;
    if (states.seed) random_ = eagerx::Random({*states.seed, 0, 0}, 0);
  }

  void callback(const eagerx::Tick& tick, const typename Io::Inputs& /*in*/,
                const typename Io::Targets& /*targets*/, typename Io::Outputs& out,
                typename Io::Done& done) {
    // To do: a random voltage at every tick, for Io::Config::seconds since the first one.
    out.u[0] = random_.uniform(0.0F, 0.0F);
    done.goal = tick.n >= start_ || running_;
  }

 private:
  eagerx::Random random_{};
  eagerx::Seq start_ = 0;
  bool running_ = false;
};

}  // namespace tutorial
