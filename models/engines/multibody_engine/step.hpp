// A step of a robot: accelerations, limits of speed, and the semi-implicit Euler method.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <eagerx/math.hpp>
#include <iterator>
#include <limits>
#include <models/engines/multibody_engine/accelerations.hpp>
#include <models/engines/multibody_engine/mimic.hpp>
#include <models/engines/multibody_engine/state.hpp>

namespace eagerx::models::multibody {

template <class Model>
class Step : public Accelerations<Model> {
  using Base = Accelerations<Model>;
  using Base::held_, Base::solve, Base::kPairCount;

 public:
  using Base::acceleration, Base::kFloating;
  using typename Base::Real, typename Base::Lane, typename Base::State, typename Base::Settings;

  Step(State& state, const Settings& settings, const Real& height)
      : Base(state, settings, height) {}

  /// Velocities, then positions.
  [[gnu::always_inline]] void advance(int sweeps) {
    set_accelerations(sweeps);
    move();
  }

  /// Of base (kFloating) and links, with the forces of contacts.
  [[gnu::always_inline]] void set_accelerations(int sweeps) {
    if constexpr (!kLimitsSpeeds) {
      solve(sweeps);
    } else {
      const ContactForces before = contact_forces();
      for (auto& velocity : held_) velocity = Real(Lane(0));
#pragma GCC unroll 1
      for (int tries = 0; tries <= kMostAgain; ++tries) {
        // Lanes without a joint that is held get the same once more.
        if (tries > 0) set_contact_forces(before);
        solve(sweeps);
        if (hold_the_fastest()) continue;
        if (tries == 0) return;
        break;
      }
      cut_speeds();
    }
  }

 private:
  static constexpr int kMostAgain = 3;  // of some 10,000 steps at random torques, 50 need more
  /// The torque that limits a joint's speed considers the joint alone. If others drive it beyond
  /// this multiple of its limit, the step is solved again with the joint held at its limit.
  static constexpr double kMostSpeed = 1.25;
  static constexpr auto kSpeedLimits = [] {
    std::array<Lane, at_least_one(State::kLinks)> limits{};
    for (std::size_t l = 0; l < State::kLinks; ++l)
      limits[l] = static_cast<Lane>(Model::kJoints[kTree<Model>.links[l].joint].max_velocity);
    return limits;
  }();
  static Real most_speed(std::size_t link) {
    return Real(static_cast<Lane>(kMostSpeed) * kSpeedLimits[link]);
  }
  static constexpr bool kLimitsSpeeds = [] {
    for (std::size_t l = 0; l < State::kLinks; ++l) {
      if (kSpeedLimits[l] < std::numeric_limits<Lane>::infinity()) return true;
    }
    return false;
  }();

  /// Of the last step, which a step begins with.
  struct ContactForces {
    Vec<Real> point[at_least_one(State::kPoints)];
    Vec<Real> pair[at_least_one(kPairCount)];
  };
  ContactForces contact_forces() const {
    ContactForces forces;
    std::copy(std::begin(this->state_.force), std::end(this->state_.force), forces.point);
    std::copy(std::begin(this->state_.pair_force), std::end(this->state_.pair_force), forces.pair);
    return forces;
  }
  void set_contact_forces(const ContactForces& forces) {
    std::copy(std::begin(forces.point), std::end(forces.point), this->state_.force);
    std::copy(std::begin(forces.pair), std::end(forces.pair), this->state_.pair_force);
  }

  [[gnu::always_inline]] Real next_velocity(std::size_t link) const {
    return this->state_.v[link] + Real(this->settings_.dt) * acceleration[link];
  }
  [[gnu::always_inline]] static Real within(const Real& velocity, const Real& most) {
    return eagerx::max(-most, eagerx::min(velocity, most));
  }
  /// Holds joints that would be too fast at the end of the step; whether there are new ones.
  [[gnu::noinline]] bool hold_the_fastest() {
    const Real zero(Lane(0));
    auto some = zero > zero;
    for (std::size_t l = 0; l < State::kLinks; ++l) {
      const Real velocity = next_velocity(l);
      const auto beyond = held_[l] == zero && eagerx::abs(velocity) > most_speed(l);
      held_[l] = eagerx::select(beyond, within(velocity, Real(kSpeedLimits[l])), held_[l]);
      some = some || beyond;
    }
    return any(some);
  }
  /// Joints that are still too fast, held ones too, lose the rest, whatever that does to momentum.
  /// Changes no lane in which none is: another lane's joint may be the reason for the call.
  [[gnu::noinline]] void cut_speeds() {
    const Real per_step(Lane(1) / this->settings_.dt);
    for (std::size_t l = 0; l < State::kLinks; ++l) {
      const Real velocity = next_velocity(l), end = within(velocity, most_speed(l));
      acceleration[l] = eagerx::select(eagerx::abs(velocity) > most_speed(l),
                                       (end - this->state_.v[l]) * per_step, acceleration[l]);
    }
  }

  [[gnu::always_inline]] void move() {
    const Real dt(this->settings_.dt);
    for (std::size_t j = 0; j < State::kLinks; ++j) {
      this->state_.v[j] += dt * acceleration[j];
      this->state_.q[j] += dt * this->state_.v[j];
    }
    follow_leaders<Model>(this->state_);
    if constexpr (kFloating) {
      const Real* const a = this->base_acceleration;
      this->state_.velocity = this->state_.velocity + Vec<Real>{a[0], a[1], a[2]} * dt;
      this->state_.spin = this->state_.spin + Vec<Real>{a[3], a[4], a[5]} * dt;
      this->state_.position = this->state_.position + this->state_.velocity * dt;
      this->state_.rotation = turned(this->state_.rotation, this->state_.spin, this->settings_.dt);
    }
  }
};

}  // namespace eagerx::models::multibody
