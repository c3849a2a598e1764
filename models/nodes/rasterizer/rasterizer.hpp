// A scene as pixels.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/message.hpp>
#include <eagerx/picture.hpp>
#include <eagerx/rate.hpp>
#include <eagerx/scene.hpp>
#include <type_traits>

namespace eagerx::models {

/// Every tick: image := the pixels of the last `scene` [rows, 16], uint8 [height, width, 3] or
/// [height, width]; white before the first message.
template <class Io>
class Rasterizer {
 public:
  void reset(const typename Io::States& /*states*/) {}

  void callback(const Tick& /*tick*/, const typename Io::Inputs& in, typename Io::Outputs& out) {
    static_assert(std::is_same_v<ScalarOf<Scene>, float> && size_of<Scene> % kSceneColumns == 0,
                  "Rasterizer: `scene` must be a drawing, float32 [rows, 16]");
    const picture::Image image{out.image.data, kWidth, kHeight, kChannels};
    in.scene.empty() ? painter_.paint(nullptr, 0, image)
                     : painter_.paint(in.scene.back().data, kSceneRows<Scene>, image);
  }

 private:
  using Scene = typename decltype(Io::Inputs::scene)::value_type;
  using Pixels = std::remove_reference_t<decltype(Io::Outputs::image)>;
  static constexpr int kWidth = Io::Config::width;
  static constexpr int kHeight = Io::Config::height;
  static constexpr int kChannels = static_cast<int>(size_of<Pixels>) / kWidth / kHeight;

  picture::Painter<static_cast<std::size_t>(kWidth)> painter_{};
};

}  // namespace eagerx::models
