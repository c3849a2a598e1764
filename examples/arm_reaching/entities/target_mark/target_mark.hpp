// Marks the hand's target on the drawing of the arm.
#pragma once

#include <eagerx/rate.hpp>
#include <eagerx/scene.hpp>

namespace arm_reaching {

/// The last `base` with a ball at the last `target` [m], a little nearer than the arm, which would
/// hide it.
template <class Io>
class TargetMark {
 public:
  void reset(const typename Io::States& /*states*/) {}

  void callback(const eagerx::Tick& /*tick*/, const typename Io::Inputs& in,
                typename Io::Outputs& out) {
    const auto& target = in.target.back();
    eagerx::SceneWriter scene(out.scene, in.base.back());
    scene.sphere({target[0], -0.1F, target[1]}, 0.05F, 0xc8553d);
  }
};

}  // namespace arm_reaching
