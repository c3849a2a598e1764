// The overlay of tutorial 7.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/math.hpp>
#include <eagerx/message.hpp>
#include <eagerx/rate.hpp>

namespace tutorial {

/// The last `base_image` with a bar for the last `u` [V] and a dot for every second since the
/// reset.
template <class Io>
class Overlay {
 public:
  void reset(const typename Io::States& /*states*/) {}

  void callback(const eagerx::Tick& tick, const typename Io::Inputs& in,
                typename Io::Outputs& out) {
    out.image = in.base_image.back();
    const float u = in.u.empty() ? 0.0F : in.u.back()[0];  // none yet at tick 0
    const float share = u / static_cast<float>(Io::Config::largest);
    const float reach = eagerx::clamp(share, -1.0F, 1.0F) * static_cast<float>(kMiddle);
    const int end = static_cast<int>(eagerx::round(reach));
    const int direction = end < 0 ? -1 : 1;
    for (int i = direction; i * direction <= end * direction; i += direction) {
      set(out, kSize - 1, kMiddle + i);
    }
    const auto seconds = static_cast<int>(Io::Rate::template seconds<float>(tick.n));
    for (int i = 0; i < seconds && i < kSize; ++i) set(out, 0, i);
  }

 private:
  using Image = typename decltype(Io::Inputs::base_image)::value_type;
  static constexpr int side() {
    int n = 1;
    while (static_cast<std::size_t>(n) * static_cast<std::size_t>(n) < eagerx::size_of<Image>) ++n;
    return n;
  }
  static constexpr int kSize = side();
  static constexpr int kMiddle = kSize / 2;
  static_assert(eagerx::size_of<Image> == static_cast<std::size_t>(kSize) * kSize,
                "Overlay: `base_image` must be a square picture");

  static void set(typename Io::Outputs& out, int row, int column) {
    constexpr std::uint8_t kWhite = 255;
    out.image[static_cast<std::size_t>(row * kSize + column)] = kWhite;
  }
};

}  // namespace tutorial
