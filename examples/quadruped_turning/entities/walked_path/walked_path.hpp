// Draws the walked path on the drawing of the robot.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <eagerx/rate.hpp>
#include <eagerx/scene.hpp>
#include <type_traits>
#include <utility>

namespace turning {

/// The last `base` [rows, 16] with the way through all `pose` [7] in m since the reset; see the
/// manifest.
template <class Io>
class WalkedPath {
 public:
  void reset(const typename Io::States& /*states*/) { count_ = 0; }

  void callback(const eagerx::Tick& /*tick*/, const typename Io::Inputs& in,
                typename Io::Outputs& out) {
    for (std::uint32_t i = 0; i < in.pose.size(); ++i) remember({in.pose[i][0], in.pose[i][1]});
    look_from_above(out.scene, in.base.back());
    draw_path(out.scene);
  }

 private:
  using Base = std::remove_cvref_t<decltype(std::declval<typename Io::Inputs>().base.back())>;
  using Scene = std::remove_cvref_t<decltype(Io::Outputs::scene)>;
  static constexpr std::size_t kCapacity =
      eagerx::kSceneRows<Scene> - eagerx::kSceneRows<Base> + 1;  // points: one more than lines

  /// Keeps `at` if it is far enough from the last point; when all places are taken, in that of the
  /// oldest.
  void remember(const eagerx::Point2& at) {
    constexpr auto kSpacing = static_cast<float>(Io::Config::spacing);
    if (count_ > 0) {
      const eagerx::Point2& last = point(count_ - 1);
      const float x = at.x - last.x;
      const float y = at.y - last.y;
      if (x * x + y * y < kSpacing * kSpacing) return;
    }
    points_[count_ % kCapacity] = at;
    ++count_;
  }
  const eagerx::Point2& point(std::size_t i) const { return points_[i % kCapacity]; }

  static void look_from_above(Scene& scene, const Base& base) {
    constexpr const auto& kEye = Io::Config::eye;
    constexpr const auto& kTarget = Io::Config::target;
    const auto metres = [](const auto& p) {
      return eagerx::Point3{static_cast<float>(p[0]), static_cast<float>(p[1]),
                            static_cast<float>(p[2])};
    };
    eagerx::SceneWriter camera(scene);
    camera.camera(metres(kEye), metres(kTarget), 0.7F, 0xe4ecf1);
    for (std::size_t i = eagerx::kSceneColumns; i < base.size(); ++i) scene[i] = base[i];
  }

  void draw_path(Scene& scene) const {
    constexpr float kHeight = 0.01F;  // over the ground, which would hide the line
    eagerx::SceneWriter lines(scene, scene);
    for (std::size_t i = count_ > kCapacity ? count_ - kCapacity + 1 : 1; i < count_; ++i) {
      const eagerx::Point2& a = point(i - 1);
      const eagerx::Point2& b = point(i);
      lines.segment({a.x, a.y, kHeight}, {b.x, b.y, kHeight}, eagerx::stroke(0xc8553d, 0.03F));
    }
  }

  std::array<eagerx::Point2, kCapacity> points_{};
  std::size_t count_ = 0;  // of all points so far
};

}  // namespace turning
