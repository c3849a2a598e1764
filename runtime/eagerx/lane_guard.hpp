// The guard of actions on their way to the actuators of a SIMD group.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <eagerx/guard.hpp>
#include <eagerx/lanes.hpp>
#include <eagerx/math.hpp>
#include <eagerx/message.hpp>
#include <eagerx/space.hpp>

namespace eagerx {

/// Guard::within() lane by lane, with its counts. The rest of a guard stays in the environment's
/// own program.
template <class Limits, std::size_t N>
class LaneGuard {
 public:
  template <class Message>
  Message within(std::size_t channel, const Space<Message>& space, const Message& message) {
    using Real = ScalarOf<Message>;
    TruthOf<Real> finite = true;
    TruthOf<Real> contained = true;
    for (std::size_t i = 0; i < size_of<Message>; ++i) {
      const Real& x = element(message, i);
      if constexpr (Floating<Real>) finite = finite && eagerx::isfinite(x);
      contained = contained && x >= element(space.low, i) && x <= element(space.high, i);
    }
    Message result;
    for (std::size_t i = 0; i < size_of<Message>; ++i) {
      const Real& low = element(space.low, i);
      const Real& high = element(space.high, i);
      const Real x = select(finite, element(message, i), Real(0));
      const Real raised = select(x >= low, x, low);
      element(result, i) = select(raised > high, high, raised);
    }
    beyond_[channel] += LaneCounts<N>(one_if<Real>(!(finite && contained)));
    return result;
  }

  void load(std::size_t lane, const Guard<Limits>& one) {
    for (std::size_t i = 0; i < kActions; ++i)
      set_lane(beyond_[i], static_cast<int>(lane), one.beyond_[i]);
  }
  void store(std::size_t lane, Guard<Limits>& one) const {
    for (std::size_t i = 0; i < kActions; ++i)
      one.beyond_[i] = eagerx::lane(beyond_[i], static_cast<int>(lane));
  }

 private:
  static constexpr std::size_t kActions = Limits::kActionNames.size();
  std::array<LaneCounts<N>, kActions> beyond_{};
};

}  // namespace eagerx
