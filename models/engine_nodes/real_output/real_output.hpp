// Several sensors of an object on RealEngine as one message.
#pragma once

#include <cstddef>
#include <eagerx/message.hpp>
#include <eagerx/rate.hpp>
#include <type_traits>

namespace eagerx::models {

/// Every tick: observation [n] := elements `index` … `index` + n − 1 of the last valid measurement.
template <class Io>
class RealOutput {
 public:
  using Simulator = typename Io::Simulator;
  using Real = typename Simulator::Real;

  void reset(const typename Io::States& /*states*/, Simulator& simulator) {
    for (std::size_t i = 0; i < kSize; ++i) {
      simulator.limit_sensor(kIndex + i, static_cast<Real>(Io::Config::low[i]),
                             static_cast<Real>(Io::Config::high[i]));
    }
  }

  void callback(const Tick& /*tick*/, const typename Io::Inputs& /*in*/, typename Io::Outputs& out,
                Simulator& simulator) {
    using Message = std::remove_cvref_t<decltype(out.observation)>;
    static_assert(size_of<Message> == kSize, "RealOutput: one value for each element of `low`");
    for (std::size_t i = 0; i < kSize; ++i) {
      element(out.observation, i) = static_cast<ScalarOf<Message>>(simulator.value(kIndex + i));
    }
  }

 private:
  static constexpr auto kIndex = static_cast<std::size_t>(Io::Config::index);
  static constexpr std::size_t kSize = Io::Config::low.size();
  static_assert(kSize == Io::Config::high.size(),
                "RealOutput: `low` and `high` have one value for each sensor");
  static_assert(kIndex + kSize <= Simulator::Model::kSensors,
                "RealOutput: `index` and `low` are beyond the sensors of the object's model");
};

}  // namespace eagerx::models
