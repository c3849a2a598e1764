// Draws a pole on a cart.
#pragma once

#include <eagerx/math.hpp>
#include <eagerx/message.hpp>
#include <eagerx/rate.hpp>
#include <eagerx/scene.hpp>

namespace eagerx::models {

/// Every tick: scene [24, 16] := the cart at x and the pole at θ of `observation` [4], in m and
/// rad, θ = 0 upright, positive to the right; before the first message, in the middle and upright.
template <class Io>
class CartPoleDrawing {
 public:
  using Simulator = typename Io::Simulator;

  void reset(const typename Io::States& /*states*/, Simulator& /*simulator*/) {}

  void callback(const Tick& /*tick*/, const typename Io::Inputs& in, typename Io::Outputs& out,
                Simulator& /*simulator*/) {
    const Array<float, 4> seen = in.observation.empty() ? Array<float, 4>{} : in.observation.back();
    const float x = seen[0];
    constexpr auto kLength = static_cast<float>(Io::Config::length);
    constexpr auto kRange = static_cast<float>(Io::Config::range);
    constexpr float kWidth = 0.5F * kLength, kHeight = 0.3F * kLength;
    const Point2 joint{x, 0.5F * kHeight};
    const Point2 end{x + kLength * eagerx::sin(seen[2]), joint.y + kLength * eagerx::cos(seen[2])};

    SceneWriter scene(out.scene);
    scene.view({0.0F, 0.4F * kLength}, 2.2F * kRange, 0xf6f4ef);
    scene.line({-1.1F * kRange, 0.0F}, {1.1F * kRange, 0.0F}, stroke(0x9aa5ad, 0.02F * kRange));
    for (const float end_stop : {-kRange, kRange}) {  // where the episode ends
      scene.line({end_stop, -0.2F * kLength}, {end_stop, 0.2F * kLength},
                 stroke(0xc9ced2, 0.02F * kRange));
    }
    for (const float wheel : {-0.3F, 0.3F}) {
      scene.circle({x + wheel * kWidth, -0.5F * kHeight}, 0.25F * kHeight, fill(0x27405a));
    }
    scene.rectangle({x, 0.0F}, kWidth, kHeight, fill(0x34526f), 0.0F, 0.15F * kHeight);
    scene.line(joint, end, stroke(0xe0932f, 0.1F * kLength));
    scene.circle(joint, 0.05F * kLength, fill(0xd9dee2));
  }
};

}  // namespace eagerx::models
