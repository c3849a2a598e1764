// Shapes of space, for the comparison of their pixels on boards.
#pragma once

#include <eagerx/math.hpp>
#include <eagerx/rate.hpp>
#include <eagerx/scene.hpp>

namespace firmware_test {

template <class Io>
class SpaceDrawing {
 public:
  void reset(const typename Io::States& /*states*/) {}

  void callback(const eagerx::Tick& /*tick*/, const typename Io::Inputs& in,
                typename Io::Outputs& out) {
    const float half = 0.5F * in.angle.back();
    const float c = eagerx::cos(half), s = eagerx::sin(half);
    const eagerx::Pose turned{{0.0F, 0.0F, 0.3F}, c, 0.6F * s, 0.0F, 0.8F * s};
    eagerx::SceneWriter scene(out.scene);
    scene.camera({1.3F, -1.6F, 1.0F}, {0.0F, 0.0F, 0.25F}, 0.8F, 0xdfe8f0);
    scene.plane({}, 1.0F, 0.25F, 0xb8c4b0);
    scene.box(turned, {0.35F, 0.25F, 0.2F}, 0x34526f);
    scene.sphere({0.5F * c, 0.4F, 0.2F}, 0.15F, 0xc8553d);
    scene.capsule({{-0.5F, 0.1F, 0.35F}, c, 0.0F, s, 0.0F}, 0.08F, 0.3F, 0xe0932f);
    scene.cylinder({{0.1F, 0.6F, 0.3F}, c, s, 0.0F, 0.0F}, 0.12F, 0.35F, 0x3f7fb0);
    scene.segment({0.0F, 0.0F, 0.3F}, {0.4F * s, 0.4F * c, 0.7F}, eagerx::stroke(0x222222, 0.02F));
  }
};

}  // namespace firmware_test
