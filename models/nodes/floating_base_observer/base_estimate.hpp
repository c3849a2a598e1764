// The Kalman filter of FloatingBaseObserver.
#pragma once

#include <array>
#include <cstddef>
#include <eagerx/math.hpp>
#include <models/engines/multibody_engine/kinematics.hpp>
#include <models/engines/multibody_engine/spatial.hpp>
#include <models/nodes/block.hpp>
#include <models/nodes/kalman_filter/covariance.hpp>

namespace eagerx::models {

template <class Lane>
struct ObserverSettings {
  Lane dt, gravity;  // [s], [m/s²]
  Lane foot;         // variance of the velocity of a foot that stands [m²/s²]
  Lane gate;         // a foot slips where the square of its innovation is as many variances
};

/// In the axes of the base, from its center of mass.
template <class Real>
struct StandingFoot {
  multibody::Vec<Real> at;     // [m]
  multibody::Vec<Real> slide;  // velocity while the base stands [m/s]
};

/// Rotation R from base to world, velocity v in the axes of the base, bias b of the gyroscope. With
/// specific force f, rate w = gyroscope − b and E = exp(w·T):
///   R := R·E,   v := Eᵀ·v + T·(f − g·Rᵀ·z).
/// Errors x = [θ, δv, δb], where R·exp(θ), v + δv and b + δb are right:
///   θ  := Eᵀ·θ − T·δb,   δv := Eᵀ·δv − T·g·[u]×·θ − T·[v]×·δb,   u = Rᵀ·z.
/// A foot at p that stands: 0 = v + w×p + slide, so the innovation is δv + [p]×·δb.
template <class Real>
struct BaseEstimate {
  using Lane = LaneOf<Real>;
  using Vec = multibody::Vec<Real>;
  using Turn = multibody::Turn<Real>;
  static constexpr std::size_t kErrors = 9;
  using P = Covariance<Real, kErrors>;
  using Row = typename P::Vector;

  struct Innovation {
    Vec value;
    Row row[3];
  };

  Turn rotation;
  Vec velocity, bias, rate;
  Real begun;   // 1 after the first inertial measurement
  Real doubts;  // ticks in which feet touch the ground, but none of them fits
  P p;

  void clear() {
    *this = {};
    rotation.w = Real(Lane(1));
  }
  [[nodiscard]] TruthOf<Real> has_begun() const { return begun != Real(Lane(0)); }
  [[nodiscard]] TruthOf<Real> distrusts(const Real& ticks) const { return doubts > ticks; }
  /// Upward, in the axes of the base.
  [[nodiscard]] Vec up() const {
    const Real zero(Lane(0));
    return rotated(opposite(rotation), Vec{zero, zero, Real(Lane(1))});
  }
  [[nodiscard]] TruthOf<Real> is_finite() const {
    const auto finite = [](const Vec& x) {
      return eagerx::isfinite(x.x) && eagerx::isfinite(x.y) && eagerx::isfinite(x.z);
    };
    return eagerx::isfinite(rotation.w) && finite({rotation.x, rotation.y, rotation.z}) &&
           finite(velocity) && finite(bias) && finite(rate) && p.is_finite();
  }

  /// At rest: the specific force points upward. The heading is 0.
  void begin(const Vec& force, const Vec& gyro, const typename P::Constants& initial) {
    clear();
    const Real size = eagerx::sqrt(dot(force, force));
    const Vec u = force * (Real(Lane(1)) / eagerx::max(size, Real(Lane(1e-6))));
    // The shortest turn from u to z; half a turn about x if they are opposite.
    const Real one(Lane(1)), zero(Lane(0)), w = one + u.z;
    const auto is_over = w > Real(Lane(1e-4));
    const auto chosen = [&](const Real& x, Lane otherwise) {
      return eagerx::select(is_over, x, Real(otherwise));
    };
    rotation = normalised({chosen(w, 0), chosen(u.y, 1), chosen(-u.x, 0), zero});
    rate = gyro;
    begun = one;
    p.reset(initial);
  }

  void predict(const Vec& force, const Vec& gyro, const typename P::Constants& noise,
               const ObserverSettings<Lane>& settings) {
    const Real dt(settings.dt), gravity(settings.gravity);
    rate = gyro - bias;
    const Turn step = exponential(rate * dt);
    rotation = normalised(rotation * step);
    const Vec u = up();
    velocity = rotated(opposite(step), velocity) + (force - u * gravity) * dt;
    // Columns of the derivative: of θ, δv, δb along each axis.
    std::array<Real, kErrors * kErrors> f;
    f.fill(Real(Lane(0)));
    const auto set = [&](std::size_t block, std::size_t column, const Vec& x) {
      f[(3 * block) * kErrors + column] = x.x;
      f[(3 * block + 1) * kErrors + column] = x.y;
      f[(3 * block + 2) * kErrors + column] = x.z;
    };
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Vec e = unit(axis), back = rotated(opposite(step), e);
      const Vec tilts = cross(u, e) * (dt * gravity);
      set(0, axis, back);
      set(1, axis, cross(u, back) * (-(dt * gravity)));
      set(1, 3 + axis, back);
      set(0, 6 + axis, e * -dt);
      set(1, 6 + axis, (tilts - cross(velocity, e)) * dt);
      set(2, 6 + axis, e);
    }
    p.predict(f, noise);
  }

  [[nodiscard]] Innovation innovation(const StandingFoot<Real>& foot) const {
    Innovation result;
    result.value = (velocity + cross(rate, foot.at) + foot.slide) * Real(Lane(-1));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      // Row `axis` of [p]× is (e × p)ᵀ.
      const Vec e = unit(axis), turn = cross(e, foot.at);
      const Real zero(Lane(0));
      result.row[axis] = {zero, zero, zero, e.x, e.y, e.z, turn.x, turn.y, turn.z};
    }
    return result;
  }
  /// Whether the foot stands, as far as the covariance says.
  [[nodiscard]] TruthOf<Real> fits(const Innovation& measured,
                                   const ObserverSettings<Lane>& settings) const {
    const Real values[3] = {measured.value.x, measured.value.y, measured.value.z};
    TruthOf<Real> fit(true);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Real variance = p.variance(measured.row[axis]) + Real(settings.foot);
      fit = fit && values[axis] * values[axis] <= variance * Real(settings.gate);
    }
    return fit;
  }
  void correct(const Innovation& measured, const ObserverSettings<Lane>& settings) {
    const Real values[3] = {measured.value.x, measured.value.y, measured.value.z};
    Row x;  // the errors
    x.fill(Real(Lane(0)));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Row& row = measured.row[axis];
      const Row gain = p.update(row, Real(settings.foot), TruthOf<Real>(true));
      Real left = values[axis];
      for (std::size_t i = 0; i < kErrors; ++i) left -= row[i] * x[i];
      for (std::size_t i = 0; i < kErrors; ++i) x[i] += gain[i] * left;
    }
    const Vec turn{x[6], x[7], x[8]};
    rotation = normalised(rotation * exponential({x[0], x[1], x[2]}));
    velocity = velocity + Vec{x[3], x[4], x[5]};
    bias = bias + turn;
    rate = rate - turn;
  }
  void note(const TruthOf<Real>& touches, const TruthOf<Real>& used) {
    const Real zero(Lane(0)), more = doubts + Real(Lane(1));
    doubts = eagerx::select(used, zero, eagerx::select(touches, more, doubts));
  }

 private:
  static Vec unit(std::size_t axis) {
    const auto is = [&](std::size_t i) { return Real(Lane(i == axis ? 1 : 0)); };
    return {is(0), is(1), is(2)};
  }
  static Turn normalised(const Turn& q) {
    const Real square = q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z;
    const Real scale = Real(Lane(1)) / eagerx::sqrt(square);
    return {q.w * scale, q.x * scale, q.y * scale, q.z * scale};
  }
  /// Of a rotation vector.
  static Turn exponential(const Vec& turn) {
    const Real one(Lane(1)), tiny(Lane(1e-6));
    const Vec half = turn * Real(Lane(0.5));
    const Real size = eagerx::sqrt(dot(half, half));
    const auto of = eagerx::sincos(size);
    const Vec axis = half * eagerx::select(size > tiny, of.sin / eagerx::max(size, tiny), one);
    return {of.cos, axis.x, axis.y, axis.z};
  }
};

}  // namespace eagerx::models
