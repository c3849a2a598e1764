// Draws a car in a valley.
#pragma once

#include <cstddef>
#include <eagerx/math.hpp>
#include <eagerx/message.hpp>
#include <eagerx/rate.hpp>
#include <eagerx/scene.hpp>

namespace eagerx::models {

/// Every tick: scene [24, 16] := a car at x of `observation` [2] in the valley 0.45·sin 3x, as Gym
/// draws it; before the first message, at 0.
template <class Io>
class MountainCarDrawing {
 public:
  using Simulator = typename Io::Simulator;

  void reset(const typename Io::States& /*states*/, Simulator& /*simulator*/) {}

  void callback(const Tick& /*tick*/, const typename Io::Inputs& in, typename Io::Outputs& out,
                Simulator& /*simulator*/) {
    const float x = in.observation.empty() ? 0.0F : in.observation.back()[0];
    SceneWriter scene(out.scene);
    scene.view({-0.3F, 0.1F}, 1.9F, 0xf6f4ef);
    draw_valley(scene);

    constexpr Point2 kFoot = on_valley(static_cast<float>(Io::Config::goal));
    scene.line(kFoot, {kFoot.x, kFoot.y + 0.25F}, points(0x4a6b8a, 2.0F));
    scene.polygon(
        {{kFoot.x, kFoot.y + 0.25F}, {kFoot.x, kFoot.y + 0.15F}, {kFoot.x + 0.1F, kFoot.y + 0.2F}},
        fill(0xe0932f));

    // Along the slope and across it, of length 1.
    const float slope = 1.35F * eagerx::cos(3.0F * x);
    const float scale = 1.0F / eagerx::sqrt(1.0F + slope * slope);
    const Point2 at = on_valley(x), along{scale, scale * slope};
    const auto placed = [&](float a, float b) {
      return Point2{at.x + a * along.x - b * along.y, at.y + a * along.y + b * along.x};
    };
    scene.line(placed(-0.05F, 0.07F), placed(0.05F, 0.07F), stroke(0x34526f, 0.06F));
    for (const float wheel : {-0.045F, 0.045F})
      scene.circle(placed(wheel, 0.025F), 0.025F, fill(0x27405a));
  }

 private:
  static constexpr float kLeft = -1.2F, kRight = 0.6F;

  static constexpr Point2 on_valley(float x) { return {x, 0.45F * eagerx::sin(3.0F * x)}; }

  template <class Writer>
  static void draw_valley(Writer& scene) {
    constexpr std::size_t kPieces = 6, kPoints = 6;
    constexpr float kStep = (kRight - kLeft) / static_cast<float>(kPieces * (kPoints - 1));
    for (std::size_t piece = 0; piece < kPieces; ++piece) {
      Point2 line[kPoints];
      for (std::size_t i = 0; i < kPoints; ++i) {
        const auto place = static_cast<float>(piece * (kPoints - 1) + i);
        line[i] = on_valley(kLeft + kStep * place);
      }
      scene.polyline(line, points(0x9aa5ad, 3.0F));
    }
  }
};

}  // namespace eagerx::models
