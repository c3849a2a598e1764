// Which feet are on the ground.
#pragma once

#include <cstddef>
#include <models/nodes/block.hpp>

namespace walking {

/// contacts [4] of the forces [3] in N on the feet; see the manifest.
template <class Io>
class FootContacts {
 public:
  void reset(const typename Io::States& /*states*/) {}

  void callback(const eagerx::Tick& /*tick*/, const typename Io::Inputs& in,
                typename Io::Outputs& out) {
    note(out, 0, in.front_left);
    note(out, 1, in.front_right);
    note(out, 2, in.rear_left);
    note(out, 3, in.rear_right);
  }

 private:
  using Real = typename Io::Real;
  static constexpr auto kThreshold = eagerx::models::constant<Real>(Io::Config::threshold);

  static void note(typename Io::Outputs& out, std::size_t foot, const auto& force) {
    const auto touches = eagerx::models::newest<Real>(force, 2) > Real(kThreshold);
    eagerx::models::put(out.contacts, foot, eagerx::select(touches, Real(1), Real(0)));
  }
};

}  // namespace walking
