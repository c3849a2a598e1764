#pragma once

#include <cstdint>
#include <eagerx/rate.hpp>

namespace async_test {

template <class Io>
class TickCounter {
 public:
  void reset(const typename Io::States& /*states*/) { count_ = 0; }
  void callback(const eagerx::Tick& /*tick*/, const typename Io::Inputs& /*in*/,
                typename Io::Outputs& out) {
    out.count = count_++;
  }

 private:
  std::int64_t count_ = 0;
};

}  // namespace async_test
