// A reset node that reaches its target after a number of callbacks.
#pragma once

#include <cstdint>
#include <eagerx/rate.hpp>

#include "../../fold.hpp"

namespace oracle {

template <class Io>
class CountReset {
 public:
  void reset(const typename Io::States& /*states*/) {
    sum_ = 0;
    callbacks_ = 0;
  }

  void callback(const eagerx::Tick& /*tick*/, const typename Io::Inputs& in,
                const typename Io::Targets& targets, typename Io::Outputs& out,
                typename Io::Done& done) {
    const std::int64_t target = targets.g0 ? (*targets.g0)[0] : 0;
    sum_ = (fold(in, sum_) * kBase + target) % kModulus;
    send(out, Io::Config::nid, callbacks_, sum_);
    ++callbacks_;
    done.g0 = callbacks_ >= Io::Config::n_reset;
  }

 private:
  std::int64_t sum_ = 0;
  std::int64_t callbacks_ = 0;
};

}  // namespace oracle
