// A reset node that reaches each of its targets after a number of callbacks.
#pragma once

#include <cstdint>
#include <eagerx/rate.hpp>
#include <tests/conformance/models/fold.hpp>

namespace oracle {

template <class Io>
class Reset2 {
 public:
  void reset(const typename Io::States& states) {
    if constexpr (requires { states.s0; })
      sum_ = states.s0.value_or(0);
    else
      sum_ = 0;
    callbacks_ = 0;
  }

  void callback(const eagerx::Tick& /*tick*/, const typename Io::Inputs& in,
                const typename Io::Targets& targets, typename Io::Outputs& out,
                typename Io::Done& done) {
    std::int64_t first = 0, second = 0;
    if constexpr (requires { targets.g0; }) first = targets.g0 ? (*targets.g0)[0] : 0;
    if constexpr (requires { targets.g1; }) second = targets.g1 ? (*targets.g1)[0] : 0;
    sum_ = ((fold(in, sum_) * kBase + first) % kModulus * kBase + second) % kModulus;
    send(out, Io::Config::nid, callbacks_, sum_);
    ++callbacks_;
    if constexpr (requires { done.g0; }) done.g0 = callbacks_ >= Io::Config::n0;
    if constexpr (requires { done.g1; }) done.g1 = callbacks_ >= Io::Config::n1;
  }

 private:
  std::int64_t sum_ = 0;
  std::int64_t callbacks_ = 0;
};

}  // namespace oracle
