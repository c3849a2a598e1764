#pragma once

#include <eagerx/rate.hpp>

namespace async_test {

template <class Io>
class Copy {
 public:
  void reset(const typename Io::States& /*states*/) {}
  void callback(const eagerx::Tick& /*tick*/, const typename Io::Inputs& in,
                typename Io::Outputs& out) {
    out.copy = in.signal.back();
  }
};

}  // namespace async_test
