// A node that folds everything it gets into a checksum.
#pragma once

#include <cstdint>
#include <eagerx/rate.hpp>

#include "../../fold.hpp"

namespace oracle {

template <class Io>
class CountNode {
 public:
  void reset(const typename Io::States& states) { sum_ = states.s0.value_or(0); }

  void callback(const eagerx::Tick& tick, const typename Io::Inputs& in,
                typename Io::Outputs& out) {
    sum_ = fold(in, sum_);
    send(out, Io::Config::nid, tick, sum_);
  }

 private:
  std::int64_t sum_ = 0;
};

}  // namespace oracle
