// Nodes of the graphs here.
#pragma once

#include <eagerx/message.hpp>
#include <eagerx/rate.hpp>

namespace plausible {

/// voltage = -angle
template <class Io>
class AngleLoop {
 public:
  void reset(const typename Io::States& /*states*/) {}
  void callback(const eagerx::Tick& /*tick*/, const typename Io::Inputs& in,
                typename Io::Outputs& out) {
    out.voltage[0] = -in.angle.back();
  }
};

/// How large the number is, without a bound.
template <class Io>
class Gauge {
 public:
  void reset(const typename Io::States& /*states*/) {}
  void callback(const eagerx::Tick& /*tick*/, const typename Io::Inputs& in,
                typename Io::Outputs& out) {
    out.size = in.signal.back() * in.signal.back();
  }
};

/// Keeps the number for a debugger.
template <class Io>
class Recorder {
 public:
  void reset(const typename Io::States& /*states*/) {}
  void callback(const eagerx::Tick& /*tick*/, const typename Io::Inputs& in) {
    last_ = in.signal.back();
  }

 private:
  float last_ = 0.0F;
};

}  // namespace plausible
