// Messages of `render:` that are pixels.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/message.hpp>
#include <eagerx/picture/coverage.hpp>

namespace eagerx::target {

/// An image as messages hold it: uint8 [height, width] or [height, width, 3].
template <class Message>
struct ImageShape {
  static constexpr bool is_image = false;
};
template <std::size_t H, std::size_t W>
struct ImageShape<Array<std::uint8_t, H, W>> {
  static constexpr bool is_image = true;
  static constexpr int height = H, width = W, channels = 1;
};
template <std::size_t H, std::size_t W>
struct ImageShape<Array<std::uint8_t, H, W, 3>> {
  static constexpr bool is_image = true;
  static constexpr int height = H, width = W, channels = 3;
};

/// The nearest pixels of an image [height, width, channels]; `to` has three channels.
inline void scale_image(const std::uint8_t* image, int width, int height, int channels,
                        const picture::Image& to) {
  std::uint8_t* pixel = to.pixels;
  for (int y = 0; y < to.height; ++y) {
    const std::ptrdiff_t row = static_cast<std::ptrdiff_t>(y) * height / to.height * width;
    for (int x = 0; x < to.width; ++x, pixel += 3) {
      const std::uint8_t* const from =
          image + (row + static_cast<std::ptrdiff_t>(x) * width / to.width) * channels;
      for (int c = 0; c < 3; ++c) pixel[c] = from[channels == 1 ? 0 : c];
    }
  }
}

}  // namespace eagerx::target
