// A state that follows a differential equation, and how it depends on where it began.
#pragma once

#include <array>
#include <cstddef>
#include <eagerx/math.hpp>
#include <eagerx/message.hpp>
#include <models/engines/ode_engine/ode_model.hpp>
#include <type_traits>

namespace eagerx::models {

/// ∂f/∂x [N][N] of a model with its parameters and input held constant: the model's own `jacobian`
/// of the same arguments as its `derivative`, else central differences.
template <OdeModel Model>
class OdeJacobian {
 public:
  using Real = typename Model::Real;
  using State = OdeState<Model>;
  static constexpr std::size_t kStates = Model::kStates;
  using Matrix = std::array<Real, kStates * kStates>;

  OdeJacobian(const OdeParameterSet<Model>& p, const OdeInputs<Model>& u)
      : derivative_(p, u), prepared_(prepare(p, u)) {}

  State slope(const State& x) const { return derivative_(x); }

  Matrix operator()(const State& x) const {
    Matrix result;
    if constexpr (requires { prepared_.jacobian(x); }) {
      const auto own = prepared_.jacobian(x);
      for (std::size_t i = 0; i < result.size(); ++i) result[i] = own[i];
    } else {
      for (std::size_t j = 0; j < kStates; ++j) {
        const Real step = kStep * eagerx::max(Real(1), eagerx::abs(x[j]));
        State above = x;
        State below = x;
        above[j] += step;
        below[j] -= step;
        const Real width = above[j] - below[j];  // as it is after rounding
        const State high = derivative_(above);
        const State low = derivative_(below);
        for (std::size_t i = 0; i < kStates; ++i)
          result[i * kStates + j] = (high[i] - low[i]) / width;
      }
    }
    return result;
  }

 private:
  /// The cube root of the resolution: there the errors of rounding and of the method are alike.
  static constexpr auto kStep = std::is_same_v<Real, double> ? Real(6e-6) : Real(5e-3);

  /// What `derivative` takes before x.
  struct ParametersAndInput {
    OdeParameterSet<Model> p;
    OdeInputs<Model> u;
    template <class M = Model>
    auto jacobian(const State& x) const requires requires {
      M::jacobian(p, u, x);
    }
    { return M::jacobian(p, u, x); }
  };
  template <class Coefficients>
  struct Prepared {
    Coefficients c;
    template <class M = Model>
    auto jacobian(const State& x) const requires requires {
      M::jacobian(c, x);
    }
    { return M::jacobian(c, x); }
  };
  static auto prepare(const OdeParameterSet<Model>& p, const OdeInputs<Model>& u) {
    if constexpr (HasCoefficients<Model>) {
      return Prepared<typename Model::Coefficients>{Model::precompute(p, u)};
    } else {
      return ParametersAndInput{p, u};
    }
  }

  OdeDerivative<Model> derivative_;
  decltype(prepare(OdeParameterSet<Model>{}, OdeInputs<Model>{})) prepared_;
};

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
