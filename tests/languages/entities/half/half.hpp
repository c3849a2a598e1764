// The same as half.py.
#pragma once

#include <eagerx/message.hpp>
#include <eagerx/rate.hpp>

namespace languages_test {

template <class Io>
class Half {
 public:
  void reset(const typename Io::States& /*states*/) {}
  void callback(const eagerx::Tick& /*tick*/, const typename Io::Inputs& in,
                typename Io::Outputs& out) {
    eagerx::element(out.half, 0) = 0.5F * eagerx::element(in.signal.back(), 0);
  }
};

}  // namespace languages_test
