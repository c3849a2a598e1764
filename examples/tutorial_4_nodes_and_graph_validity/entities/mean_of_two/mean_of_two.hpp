// The filter of tutorial 4.
#pragma once

#include <eagerx/message.hpp>
#include <eagerx/rate.hpp>

namespace tutorial {

/// (x + x before)/2, where x before is 0 at the first tick of an episode.
template <class Io>
class MeanOfTwo {
 public:
  void reset(const typename Io::States& /*states*/) { before_ = 0; }

  void callback(const eagerx::Tick& /*tick*/, const typename Io::Inputs& in,
                typename Io::Outputs& out) {
    const float x = in.signal.back()[0];  // the newest message
    out.filtered[0] = (x + before_) / 2;
    before_ = x;
  }

 private:
  float before_ = 0;
};

}  // namespace tutorial
