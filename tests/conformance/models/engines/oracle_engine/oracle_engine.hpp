// An engine whose state depends on every input in order.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/rate.hpp>

#include "../../fold.hpp"

namespace oracle {

/// Data of every object: its state, and the last value of each actuator.
template <class Model>
struct OracleSimulator {
  std::int64_t state = 0;
  std::int64_t inputs[Model::kActuators]{};

  void reset() { *this = {}; }
  std::int64_t input() const {
    std::int64_t sum = 0;
    for (const std::int64_t value : inputs) sum += value;
    return sum % kModulus;
  }
};

/// Tick k: state := (131 state + 7 input + k) mod 1000003.
template <class Io>
class OracleEngine {
 public:
  void reset(const typename Io::States& /*states*/) {}

  template <class... Simulators>
  void callback(const eagerx::Tick& tick, Simulators&... simulators) {
    constexpr std::int64_t kInputFactor = 7;
    const auto k = static_cast<std::int64_t>(tick.n);
    ((simulators.state =
          (simulators.state * kBase + simulators.input() * kInputFactor + k) % kModulus),
     ...);
  }
};

}  // namespace oracle
