// The overlay of the tutorial.
#pragma once

#include <cstdint>
#include <eagerx/math.hpp>
#include <eagerx/rate.hpp>
#include <eagerx/scene.hpp>

namespace drawn {

/// The last `base` with the time since the reset and the last `u` [V], as numbers and as a bar.
template <class Io>
class Overlay {
 public:
  void reset(const typename Io::States& /*states*/) {}

  void callback(const eagerx::Tick& tick, const typename Io::Inputs& in,
                typename Io::Outputs& out) {
    const float u = in.u.empty() ? 0.0F : in.u.back()[0];  // none yet at tick 0
    const float share = eagerx::clamp(u / static_cast<float>(Io::Config::largest), -1.0F, 1.0F);

    eagerx::SceneWriter scene(out.scene, in.base.back());
    scene.on_screen();  // from here on x and y go from 0 to 1 over the picture
    scene.number({0.05F, 0.92F}, 0.032F, "t = # s", Io::Rate::template seconds<float>(tick.n), 1,
                 kText);
    scene.number({0.95F, 0.92F}, 0.032F, "u = # V", u, 2, kText, eagerx::Align::right);
    scene.rectangle({0.5F, 0.06F}, 0.6F, 0.022F, eagerx::fill(0xdcd9d0), 0.0F, 0.011F);
    scene.line({0.5F, 0.06F}, {0.5F + 0.29F * share, 0.06F},
               eagerx::stroke(share < 0.0F ? 0x3f7fb0 : 0xc8553d, 0.022F));
    scene.line({0.5F, 0.042F}, {0.5F, 0.078F}, eagerx::stroke(kText, 0.004F));
  }

 private:
  static constexpr std::uint32_t kText = 0x3a4650;
};

}  // namespace drawn
