// The Jacobian of a model: the derivative of its equations by the state.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <eagerx/math.hpp>
#include <eagerx/math/dual.hpp>
#include <eagerx/message.hpp>
#include <models/engines/ode_engine/ode_model.hpp>
#include <type_traits>

namespace eagerx::models {
namespace detail {

template <class Model>
concept HasJacobianOfCoefficients = HasCoefficients<Model> &&
    requires(const typename Model::Coefficients& c, OdeState<Model> x) {
  Model::jacobian(c, x);
};
template <class Model>
concept HasJacobianOfInputs = requires(const OdeParameterSet<Model>& p, const OdeInputs<Model>& u,
                                       OdeState<Model> x) {
  Model::jacobian(p, u, x);
};

/// The model's own.
template <class Model>
class OwnJacobian {
 public:
  constexpr OwnJacobian(const OdeParameterSet<Model>& p, const OdeInputs<Model>& u)
      : p_(p), u_(u) {}
  constexpr auto operator()(const OdeState<Model>& x) const { return Model::jacobian(p_, u_, x); }

 private:
  OdeParameterSet<Model> p_;
  OdeInputs<Model> u_;
};
template <class Model>
requires HasJacobianOfCoefficients<Model>
class OwnJacobian<Model> {
 public:
  constexpr OwnJacobian(const OdeParameterSet<Model>& p, const OdeInputs<Model>& u)
      : coefficients_(Model::precompute(p, u)) {}
  constexpr auto operator()(const OdeState<Model>& x) const {
    return Model::jacobian(coefficients_, x);
  }

 private:
  typename Model::Coefficients coefficients_;
};

/// The model over dual numbers with a derivative for each state.
template <class Model>
using DualModelOf = typename ModelOver<Model, Dual<typename Model::Real, Model::kStates>>::type;

template <class Model>
concept TakesDualNumbers = requires {
  typename DualModelOf<Model>;
  requires std::same_as<typename DualModelOf<Model>::Real,
                        Dual<typename Model::Real, Model::kStates>>;
}
&&!requires {
  requires !Model::dual_numbers;
};

template <class Model>
class DualJacobian {
 public:
  constexpr DualJacobian(const OdeParameterSet<Model>& p, const OdeInputs<Model>& u)
      : derivative_(constants(p), constants(u)) {}
  constexpr auto operator()(const OdeState<Model>& x) const {
    constexpr std::size_t kStates = Model::kStates;
    Array<Number, kStates> at{};
    for (std::size_t i = 0; i < kStates; ++i) at[i] = Number::variable(x[i], i);
    const Array<Number, kStates> slope = derivative_(at);
    std::array<typename Model::Real, kStates * kStates> result{};
    for (std::size_t i = 0; i < result.size(); ++i)
      result[i] = slope[i / kStates].derivative[i % kStates];
    return result;
  }

 private:
  using Number = typename DualModelOf<Model>::Real;

  template <std::size_t N>
  static constexpr Array<Number, N> constants(const Array<typename Model::Real, N>& values) {
    Array<Number, N> result{};
    for (std::size_t i = 0; i < N; ++i) result[i] = Number(values[i]);
    return result;
  }
  OdeDerivative<DualModelOf<Model>> derivative_;
};

/// Central differences.
template <class Model>
class DifferenceJacobian {
 public:
  using Real = typename Model::Real;
  constexpr DifferenceJacobian(const OdeParameterSet<Model>& p, const OdeInputs<Model>& u)
      : derivative_(p, u) {}
  constexpr auto operator()(const OdeState<Model>& x) const {
    constexpr std::size_t kStates = Model::kStates;
    std::array<Real, kStates * kStates> result{};
    for (std::size_t j = 0; j < kStates; ++j) {
      const Real step = Real(kStep) * eagerx::max(Real(1), eagerx::abs(x[j]));
      OdeState<Model> above = x;
      OdeState<Model> below = x;
      above[j] += step;
      below[j] -= step;
      const Real width = above[j] - below[j];  // as it is after rounding
      const OdeState<Model> high = derivative_(above);
      const OdeState<Model> low = derivative_(below);
      for (std::size_t i = 0; i < kStates; ++i)
        result[i * kStates + j] = (high[i] - low[i]) / width;
    }
    return result;
  }

 private:
  /// The cube root of the resolution, at which rounding and truncation errors are of equal size.
  static constexpr auto kStep =
      std::is_same_v<LaneOf<Real>, double> ? LaneOf<Real>(6e-6) : LaneOf<Real>(5e-3);

  OdeDerivative<Model> derivative_;
};

template <class Model>
struct JacobianOf {
  using type = DifferenceJacobian<Model>;
};
template <class Model>
requires(HasJacobianOfInputs<Model> || HasJacobianOfCoefficients<Model>) struct JacobianOf<Model> {
  using type = OwnJacobian<Model>;
};
template <class Model>
requires(TakesDualNumbers<Model> && !HasJacobianOfInputs<Model> &&
         !HasJacobianOfCoefficients<Model>) struct JacobianOf<Model> {
  using type = DualJacobian<Model>;
};

}  // namespace detail

/// f and ∂f/∂x [N][N] of a model with its parameters and input held constant. ∂f/∂x is the model's
/// own `jacobian`; else it is computed with dual numbers, exact but for rounding; else, if the
/// model is not a template over Io or says `dual_numbers = false`, with central differences.
template <OdeModel Model>
class OdeJacobian {
 public:
  using Real = typename Model::Real;
  using State = OdeState<Model>;
  static constexpr std::size_t kStates = Model::kStates;
  using Matrix = std::array<Real, kStates * kStates>;  // row-major

  constexpr OdeJacobian(const OdeParameterSet<Model>& p, const OdeInputs<Model>& u)
      : derivative_(p, u), jacobian_(p, u) {}

  constexpr State slope(const State& x) const { return derivative_(x); }

  constexpr Matrix operator()(const State& x) const {
    const auto own = jacobian_(x);
    Matrix result{};
    for (std::size_t i = 0; i < result.size(); ++i) result[i] = own[i];
    return result;
  }

 private:
  OdeDerivative<Model> derivative_;
  typename detail::JacobianOf<Model>::type jacobian_;
};

}  // namespace eagerx::models
