// Draws a disc pendulum.
#pragma once

#include <eagerx/math.hpp>
#include <eagerx/rate.hpp>
#include <eagerx/scene.hpp>

namespace eagerx::models {

/// Every tick: scene [24, 16] := a disc with a weight, or a mark, at `angle` [rad], 0 upright;
/// before the first message, upright.
template <class Io>
class PendulumDrawing {
 public:
  using Simulator = typename Io::Simulator;

  void reset(const typename Io::States& /*states*/, Simulator& /*simulator*/) {}

  void callback(const Tick& /*tick*/, const typename Io::Inputs& in, typename Io::Outputs& out,
                Simulator& /*simulator*/) {
    const float turned = in.angle.empty() ? 0.0F : static_cast<float>(in.angle.back());
    const float angle = Io::Config::clockwise ? turned : -turned;
    const float s = eagerx::sin(angle), c = eagerx::cos(angle);
    constexpr auto kLength = static_cast<float>(Io::Config::length);
    constexpr float kRadius = 1.5F * kLength;
    const auto on_disc = [&](float r) { return Point2{r * s, r * c}; };

    SceneWriter scene(out.scene);
    scene.view({}, 5.0F * kLength, 0xf6f4ef);
    // Where upright and down are.
    scene.line({0.0F, 1.68F * kLength}, {0.0F, 1.95F * kLength}, stroke(0x9aa5ad, 0.05F * kLength));
    scene.line({0.0F, -1.68F * kLength}, {0.0F, -1.8F * kLength},
               stroke(0xc9ced2, 0.05F * kLength));
    scene.circle({0.06F * kLength, -0.09F * kLength}, kRadius, fill(0x000000, 0.1F));
    scene.circle({}, kRadius, fill(0x34526f));
    scene.circle({}, 0.97F * kRadius, stroke(0x27405a, 0.06F * kRadius));
    if constexpr (Io::Config::weight) {
      scene.line({}, on_disc(kLength), stroke(0x4a6b8a, 0.16F * kLength));
      scene.circle(on_disc(kLength), 0.3F * kLength, fill(0xe0932f));
      scene.circle(on_disc(kLength), 0.285F * kLength, stroke(0xb87420, 0.03F * kLength));
    } else {
      scene.line(on_disc(0.9F * kRadius), on_disc(0.3F * kRadius),
                 stroke(0xe0932f, 0.1F * kLength));
      scene.circle({}, 0.22F * kRadius, fill(0x4a6b8a));
    }
    scene.circle({}, 0.14F * kLength, fill(0xd9dee2));
    scene.circle({}, 0.05F * kLength, fill(0x27405a));
  }
};

}  // namespace eagerx::models
