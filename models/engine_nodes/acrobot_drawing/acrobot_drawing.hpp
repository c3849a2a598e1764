// Draws two links, one hanging from the other.
#pragma once

#include <eagerx/message.hpp>
#include <eagerx/rate.hpp>
#include <eagerx/scene.hpp>

namespace eagerx::models {

/// Every tick: scene [24, 16] := links at the angles of `observation` [6], [cos θ1, sin θ1, cos θ2,
/// sin θ2, …], 0 hanging, θ2 relative to the first link; before the first message, hanging.
template <class Io>
class AcrobotDrawing {
 public:
  using Simulator = typename Io::Simulator;

  void reset(const typename Io::States& /*states*/, Simulator& /*simulator*/) {}

  void callback(const Tick& /*tick*/, const typename Io::Inputs& in, typename Io::Outputs& out,
                Simulator& /*simulator*/) {
    constexpr Array<float, 6> kHanging{{1.0F, 0.0F, 1.0F, 0.0F, 0.0F, 0.0F}};
    const Array<float, 6> seen = in.observation.empty() ? kHanging : in.observation.back();
    const float c1 = seen[0], s1 = seen[1];
    const float c12 = c1 * seen[2] - s1 * seen[3], s12 = s1 * seen[2] + c1 * seen[3];
    constexpr auto kLength = static_cast<float>(Io::Config::length);
    const Point2 elbow{kLength * s1, -kLength * c1};
    const Point2 end{elbow.x + kLength * s12, elbow.y - kLength * c12};

    SceneWriter scene(out.scene);
    scene.view({}, 4.4F * kLength, 0xf6f4ef);
    scene.line({-2.2F * kLength, kLength}, {2.2F * kLength, kLength},
               stroke(0x9aa5ad, 0.02F * kLength));
    scene.line({}, elbow, stroke(0x34526f, 0.2F * kLength));
    scene.line(elbow, end, stroke(0x4a6b8a, 0.2F * kLength));
    scene.circle({}, 0.06F * kLength, fill(0xd9dee2));
    scene.circle(elbow, 0.06F * kLength, fill(0xd9dee2));
    scene.circle(end, 0.06F * kLength, fill(0xe0932f));
  }
};

}  // namespace eagerx::models
