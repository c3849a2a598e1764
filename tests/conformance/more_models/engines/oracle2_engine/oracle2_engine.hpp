// An engine whose objects have two states, set one by one.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <eagerx/rate.hpp>
#include <tests/conformance/models/fold.hpp>

namespace oracle {

template <class Model>
struct Oracle2Simulator {
  std::array<std::int64_t, 2> state{};
  std::array<std::int64_t, Model::kActuators> inputs{};

  void reset() { *this = {}; }
  std::int64_t input() const {
    std::int64_t sum = 0;
    for (const std::int64_t value : inputs) sum += value;
    return sum % kModulus;
  }
};

/// Tick k: [a, b] := [131 a + 7 input + k + b, 17 b + k] mod 1000003.
template <class Io>
class Oracle2Engine {
 public:
  void reset(const typename Io::States& /*states*/) {}

  template <class... Simulators>
  void callback(const eagerx::Tick& tick, Simulators&... simulators) {
    (advance(static_cast<std::int64_t>(tick.n), simulators), ...);
  }

 private:
  static void advance(std::int64_t k, auto& simulator) {
    constexpr std::int64_t kInputFactor = 7, kSecondFactor = 17;
    const auto [a, b] = simulator.state;
    simulator.state = {(a * kBase + simulator.input() * kInputFactor + k + b) % kModulus,
                       (b * kSecondFactor + k) % kModulus};
  }
};

}  // namespace oracle
