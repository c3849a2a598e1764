// A node as somebody writes it who does not think of NaN.
#pragma once

#include <eagerx/message.hpp>
#include <eagerx/rate.hpp>

namespace own_loop {

template <class Io>
class PlainSum {
 public:
  void reset(const typename Io::States& /*states*/) { sum_ = 0; }
  void callback(const eagerx::Tick& /*tick*/, const typename Io::Inputs& in,
                typename Io::Outputs& out) {
    sum_ += eagerx::element(in.signal.back(), 0) * static_cast<float>(Io::Rate::period_s);
    eagerx::element(out.y, 0) = sum_;
  }

 private:
  float sum_ = 0;
};

}  // namespace own_loop
