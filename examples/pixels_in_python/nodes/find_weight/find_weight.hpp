// Finds the orange weight of a pendulum in an image, as find_weight.py does.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/message.hpp>
#include <eagerx/rate.hpp>

namespace pixels_in_python {

template <class Io>
class FindWeight {
 public:
  void reset(const typename Io::States& /*states*/) {}

  void callback(const eagerx::Tick& /*tick*/, const typename Io::Inputs& in,
                typename Io::Outputs& out) {
    const auto& image = in.image.back();
    std::int32_t total = 0, right = 0, down = 0;  // at most 215 * 63 * 64 * 64
    for (std::size_t row = 0; row < kSize; ++row) {
      for (std::size_t column = 0; column < kSize; ++column) {
        const std::size_t at = (row * kSize + column) * 3;
        const int weight = static_cast<int>(eagerx::element(image, at)) -
                           static_cast<int>(eagerx::element(image, at + 2)) - 40;
        if (weight <= 0) continue;
        total += weight;
        right += weight * static_cast<std::int32_t>(column);
        down += weight * static_cast<std::int32_t>(row);
      }
    }
    eagerx::element(out.position, 0) = total > 0 ? from_middle(right, total) : 0.0F;
    eagerx::element(out.position, 1) = total > 0 ? -from_middle(down, total) : 0.0F;
  }

 private:
  static constexpr std::size_t kSize = 64;

  static float from_middle(std::int32_t sum, std::int32_t total) {
    constexpr float kMiddle = (kSize - 1) / 2.0F, kHalf = kSize / 2.0F;
    return (static_cast<float>(sum) / static_cast<float>(total) - kMiddle) / kHalf;
  }
};

}  // namespace pixels_in_python
