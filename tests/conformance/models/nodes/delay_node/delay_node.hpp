// A node that changes the delay of its first input at every reset.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/rate.hpp>

#include "../../fold.hpp"

namespace oracle {

template <class Io>
class DelayNode {
 public:
  void reset(const typename Io::States& states, typename Io::Delays delays) {
    sum_ = states.s0.value_or(0);
    delays.i0 = Io::Config::delays[resets_ % Io::Config::delays.size()];
    ++resets_;
  }

  void callback(const eagerx::Tick& tick, const typename Io::Inputs& in,
                typename Io::Outputs& out) {
    sum_ = fold(in, sum_);
    send(out, Io::Config::nid, tick, sum_);
  }

 private:
  std::int64_t sum_ = 0;
  std::size_t resets_ = 0;
};

}  // namespace oracle
