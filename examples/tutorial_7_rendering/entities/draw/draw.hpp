// The picture of tutorial 7.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/math.hpp>
#include <eagerx/rate.hpp>

namespace tutorial {

/// A line from the middle of the picture at the angle θ [rad], 0 upwards.
template <class Io>
class Draw {
 public:
  void reset(const typename Io::States& /*states*/) {}

  void callback(const eagerx::Tick& /*tick*/, const typename Io::Inputs& in,
                typename Io::Outputs& out) {
    constexpr int kSize = Io::Config::size;
    constexpr int kMiddle = kSize / 2;
    constexpr std::uint8_t kGrey = 128;
    out.image = {};
    const float theta = in.theta.back();
    for (int r = 0; r < kMiddle - 1; ++r) {
      const auto distance = static_cast<float>(r);
      const auto column = kMiddle + static_cast<int>(eagerx::round(distance * eagerx::sin(theta)));
      const auto row = kMiddle - static_cast<int>(eagerx::round(distance * eagerx::cos(theta)));
      out.image[static_cast<std::size_t>(row * kSize + column)] = kGrey;
    }
  }
};

}  // namespace tutorial
