// A state that follows a differential equation, and its derivative by the initial state.
#pragma once

#include <cstddef>
#include <models/engines/ode_engine/ode_jacobian.hpp>
#include <models/engines/ode_engine/ode_model.hpp>

namespace eagerx::models {

/// x [N] after some time, and F = ∂x/∂(x at the beginning) [N][N].
template <OdeModel Model>
struct OdePrediction {
  using Real = typename Model::Real;
  using Jacobian = OdeJacobian<Model>;
  static constexpr std::size_t kStates = Model::kStates;

  OdeState<Model> x;
  typename Jacobian::Matrix f;

  static OdePrediction from(const OdeState<Model>& x) {
    OdePrediction begin{x, {}};
    for (std::size_t i = 0; i < kStates; ++i) begin.f[i * kStates + i] = Real(1);
    return begin;
  }

  /// A step of rk4_step, which x takes with the same bits, and its derivative: the same step of
  /// dF/dt = ∂f/∂x·F. In loops: F is too large to be unrolled.
  void step(const Jacobian& jacobian, Real step_s) {
    const Real half = step_s * Real(0.5);
    const Real sixth = step_s * Real(1.0 / 6.0);
    OdePrediction sum = slope(jacobian);
    OdePrediction k = sum;
    for (int stage = 1; stage < 4; ++stage) {
      OdePrediction at = *this;
      at.add(stage == 3 ? step_s : half, k);
      k = at.slope(jacobian);
      sum.add(stage == 3 ? Real(1) : Real(2), k);
    }
    add(sixth, sum);
  }

 private:
  OdePrediction slope(const Jacobian& jacobian) const {
    OdePrediction result;
    result.x = jacobian.slope(x);
    const auto j = jacobian(x);
    for (std::size_t i = 0; i < kStates; ++i) {
      for (std::size_t column = 0; column < kStates; ++column) {
        Real sum = j[i * kStates] * f[column];
        for (std::size_t k = 1; k < kStates; ++k)
          sum += j[i * kStates + k] * f[k * kStates + column];
        result.f[i * kStates + column] = sum;
      }
    }
    return result;
  }
  /// += factor·other
  void add(Real factor, const OdePrediction& other) {
    for (std::size_t i = 0; i < kStates; ++i) x[i] += factor * other.x[i];
    for (std::size_t i = 0; i < f.size(); ++i) f[i] += factor * other.f[i];
  }
};

}  // namespace eagerx::models
