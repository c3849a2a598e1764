// Torques of joints that depend on position and velocity, so that they are stable at every step.
//
// A torque that is τ at the velocity v and falls by `slope` for each rad/s is, at the velocity v'
// of the end of the step, τ − slope·(v' − v). With v' = v + dt·a this adds dt·slope to the diagonal
// of the mass matrix, and nothing else: the step stays one factorisation.
#pragma once

#include <eagerx/math.hpp>

namespace eagerx::models::multibody {

/// At the velocity now, and how much less for each rad/s more.
template <class Real>
struct JointTorque {
  Real now, slope;
};
template <class Real>
[[gnu::always_inline]] inline JointTorque<Real> operator+(const JointTorque<Real>& a,
                                                          const JointTorque<Real>& b) {
  return {a.now + b.now, a.slope + b.slope};
}

template <class Real>
[[gnu::always_inline]] inline JointTorque<Real> operator*(const JointTorque<Real>& a,
                                                          const Real& s) {
  return {a.now * s, a.slope * s};
}

/// An actuator's command for a joint, in the link's coordinate. Torques are N·m or N.
template <class Real>
struct JointDrive {
  Real torque;          // without a servo
  Real position;        // of the servo
  Real stiffness;       // [N·m/rad]
  Real damping;         // [N·m·s/rad]
  Real most;            // of the servo; 0: there is none
  Real motor_velocity;  // dry friction is a motor that holds 0
  Real motor_torque;    // at most; 0: there is none
  Real applied;         // by the actuator in the last step
  // Factors of the environment, 1 at first.
  Real strength, stiffness_scale, damping_scale;
};

/// Stiffness and damping at the position and velocity of the end of the step. A torque beyond
/// `most` is `most`, and has no slope.
template <class Real>
[[gnu::always_inline]] inline JointTorque<Real> servo_torque(const JointDrive<Real>& drive,
                                                             const Real& q, const Real& v,
                                                             LaneOf<Real> dt) {
  const Real stiffness = drive.stiffness * drive.stiffness_scale;
  const Real slope = drive.damping * drive.damping_scale + Real(dt) * stiffness;
  const Real wanted = stiffness * (drive.position - q) - slope * v;
  const auto inside = (wanted < drive.most) & (wanted > -drive.most);
  const Real zero(LaneOf<Real>(0));
  return {eagerx::max(eagerx::min(wanted, drive.most), -drive.most),
          eagerx::select(inside, slope, zero)};
}

/// How many times firmer than the joint's inertia in a step a motor and a stop are.
template <class Lane>
inline constexpr Lane kFirmness = Lane(1000);
/// The fraction of a joint's penetration of its stop that a step corrects.
template <class Lane>
inline constexpr Lane kStopCorrection = Lane(0.2);
/// And how fast it comes back at most [rad/s, m/s]: a reset may have put it far beyond.
template <class Lane>
inline constexpr Lane kStopSpeed = Lane(5);

/// The motion of a joint in the step without motor and stops, by its own inertia.
template <class Real>
struct FreeJoint {
  Real inertia;   // with what slopes add to it
  Real velocity;  // at the end of the step
};
template <class Real>
[[gnu::always_inline]] inline FreeJoint<Real> free_joint(const Real& v, const Real& inertia,
                                                         const JointTorque<Real>& sum,
                                                         const Real& needed, LaneOf<Real> dt) {
  const Real effective = inertia + Real(dt) * sum.slope;
  return {effective, v + Real(dt) * (sum.now - needed) / effective};
}

/// A motor that holds a velocity with at most a torque, and Coulomb's friction, which holds 0: the
/// torque is slope·(target − v'). Where `most` is enough the slope is as firm as `kFirmness`, so a
/// held joint creeps by load·dt/(1000·inertia); elsewhere the slope makes the torque `most`.
template <class Real>
[[gnu::always_inline]] inline JointTorque<Real> motor_torque(const Real& target, const Real& most,
                                                             const Real& v,
                                                             const FreeJoint<Real>& free,
                                                             LaneOf<Real> dt) {
  using Lane = LaneOf<Real>;
  const Real tiny(Lane(1e-30)), step(dt);
  const Real left = eagerx::abs(target - free.velocity) - step * most / free.inertia;
  const Real firm = free.inertia * Real(kFirmness<Lane> / dt);
  const Real slope = eagerx::min(firm, most / eagerx::max(left, tiny));
  return {slope * (target - v), slope};
}

/// Damping of the joint itself.
template <class Real>
[[gnu::always_inline]] inline JointTorque<Real> damping_torque(const Real& damping, const Real& v) {
  return {-(damping * v), damping};
}

/// A spring of the joint itself, at the position of the end of the step.
template <class Real>
[[gnu::always_inline]] inline JointTorque<Real> spring_torque(const Real& stiffness,
                                                              const Real& rest, const Real& q,
                                                              const Real& v, LaneOf<Real> dt) {
  const Real slope = Real(dt) * stiffness;
  return {stiffness * (rest - q) - slope * v, slope};
}

/// A stop at `end` in the direction `side`, +1 or −1. It acts if the joint would be beyond the stop
/// at the end of the step, and lets it move up to the stop. A penetration shrinks by
/// `kStopCorrection` per step.
template <class Real>
[[gnu::always_inline]] inline JointTorque<Real> stop_torque(const Real& end, LaneOf<Real> side,
                                                            const Real& q, const Real& v,
                                                            const FreeJoint<Real>& free,
                                                            LaneOf<Real> dt) {
  using Lane = LaneOf<Real>;
  const Real zero(Lane(0));
  const Real room = (end - q) * Real(side);  // negative beyond the stop
  const Real part =
      eagerx::select(room < zero, Real(kStopCorrection<Lane> / dt), Real(Lane(1) / dt));
  // Velocity towards the stop.
  const Real most = eagerx::max(room * part, Real(-kStopSpeed<Lane>));
  const auto acts = free.velocity * Real(side) > most;
  const Real slope = free.inertia * Real(kFirmness<Lane> / dt);
  const Real gap = eagerx::select(acts, most * Real(side) - v, zero);
  return {slope * gap, eagerx::select(acts, slope, zero)};
}

/// A limit of speed: beyond it, all that is too fast is gone after a step.
template <class Real>
[[gnu::always_inline]] inline JointTorque<Real> speed_limit_torque(const Real& limit, const Real& v,
                                                                   const FreeJoint<Real>& free,
                                                                   LaneOf<Real> dt) {
  using Lane = LaneOf<Real>;
  const Real zero(Lane(0));
  const auto acts = eagerx::abs(free.velocity) > limit;
  const Real slope = free.inertia * Real(kFirmness<Lane> / dt);
  const Real end = eagerx::max(eagerx::min(free.velocity, limit), -limit);
  return {eagerx::select(acts, slope * (end - v), zero), eagerx::select(acts, slope, zero)};
}

/// Instead of all other torques: the joint has the velocity `target` at the end of the step.
template <class Real>
[[gnu::always_inline]] inline JointTorque<Real> held_torque(const Real& target, const Real& v,
                                                            const FreeJoint<Real>& free,
                                                            LaneOf<Real> dt) {
  const Real slope = free.inertia * Real(kFirmness<LaneOf<Real>> / dt);
  return {slope * (target - v), slope};
}

}  // namespace eagerx::models::multibody
