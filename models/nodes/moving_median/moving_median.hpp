// The median of the last samples.
#pragma once

#include <array>
#include <cstddef>
#include <eagerx/rate.hpp>
#include <models/nodes/block.hpp>

namespace eagerx::models {

/// The median of the last n signals that were numbers, or of as many as there are; the mean of the
/// middle two if they are even. Zero before the first. NaN and what is missing are left out.
/// Sorts lane by lane.
template <class Io>
class MovingMedian {
 public:
  void reset(const typename Io::States& /*states*/) {
    last_ = {};
    count_ = {};
  }

  void callback(const Tick& /*tick*/, const typename Io::Inputs& in, typename Io::Outputs& out) {
    for (std::size_t i = 0; i < kSize; ++i) {
      Real y(0);
      const Real x = newest<Real>(in.signal, i, Real(FloatFormat<LaneOf<Real>>::nan));
      for (int k = 0; k < lanes<Real>; ++k) {
        take(i, k, lane(x, k));
        set_lane(y, k, median(i, k));
      }
      put(out.y, i, y);
    }
  }

 private:
  using Real = typename Io::Real;
  using Lane = LaneOf<Real>;
  static constexpr std::size_t kSize = elements_of<decltype(Io::Outputs::y)>;
  static constexpr auto kCount = static_cast<std::size_t>(Io::Config::n);
  static_assert(Io::Config::n >= 1, "MovingMedian: `n` is at least 1");

  void take(std::size_t i, int k, Lane x) {
    if (eagerx::isnan(x)) return;
    for (std::size_t m = kCount - 1; m > 0; --m) set_lane(last_[i][m], k, lane(last_[i][m - 1], k));
    set_lane(last_[i][0], k, x);
    const Lane count = lane(count_[i], k);
    if (count < static_cast<Lane>(kCount)) set_lane(count_[i], k, count + Lane(1));
  }

  Lane median(std::size_t i, int k) const {
    const auto count = static_cast<std::size_t>(lane(count_[i], k));
    if (count == 0) return Lane(0);
    std::array<Lane, kCount> sorted{};
    for (std::size_t m = 0; m < count; ++m) {
      const Lane x = lane(last_[i][m], k);
      std::size_t place = m;
      for (; place > 0 && sorted[place - 1] > x; --place) sorted[place] = sorted[place - 1];
      sorted[place] = x;
    }
    const Lane upper = sorted[count / 2];
    return count % 2 == 1 ? upper : (sorted[count / 2 - 1] + upper) / Lane(2);
  }

  std::array<std::array<Real, kCount>, kSize> last_{};  // the newest first
  std::array<Real, kSize> count_{};                     // how many of them there are
};

}  // namespace eagerx::models
