#pragma once

#include <cstdint>
#include <eagerx/rate.hpp>

namespace async_test {

template <class Io>
class Tally {
 public:
  void reset(const typename Io::States& /*states*/) {}
  void callback(const eagerx::Tick& /*tick*/, const typename Io::Inputs& in,
                typename Io::Outputs& out) {
    out.size = static_cast<std::int64_t>(in.signal.size());
  }
};

}  // namespace async_test
