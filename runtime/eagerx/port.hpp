// Inputs of a controller that was cut out of a graph, at the rates of their senders.
#pragma once

#include <eagerx/rate.hpp>

namespace eagerx {

/// Passes on the newest action. A main loop supplies one at every step; downstream nodes receive
/// and count as many as in the whole graph.
template <class Io>
class Port {
 public:
  void reset(const typename Io::States& /*states*/) {}

  void callback(const Tick& /*tick*/, const typename Io::Inputs& in, typename Io::Outputs& out) {
    out.value = in.signal.back();
  }
};

}  // namespace eagerx
