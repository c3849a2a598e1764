// Requirements of OdeEngine on a model of an ordinary differential equation.
#pragma once

#include <concepts>
#include <eagerx/message.hpp>

namespace eagerx::models {

/// A model dx/dt = f(x, u, p) with constant input u and parameters p during an engine tick. It has
///   using Real = …;                                    // float or double
///   static constexpr std::size_t kStates, kInputs, kParameters;  // sizes of x, u, p, at least 1
///   static Array<Real, kParameters> default_parameters();
///   static Array<Real, kStates> derivative(const Array<Real, kParameters>& p,
///                                          const Array<Real, kInputs>& u,
///                                          Array<Real, kStates> x);
/// or, where products of p and u are worth computing once for each engine tick and not in each
/// stage of the integrator, instead of the last one:
///   struct Coefficients {…};
///   static Coefficients precompute(const Array<Real, kParameters>& p,
///                                  const Array<Real, kInputs>& u);
///   static Array<Real, kStates> derivative(const Coefficients& c, Array<Real, kStates> x);
/// It may have ∂f/∂x, row-major, with the same arguments as `derivative`, for linearization:
///   static Array<Real, kStates, kStates> jacobian(…);
/// Without it, `derivative` is computed with Real = eagerx::Dual (eagerx/math/dual.hpp), so it must
/// be written over Io::Real alone. One that cannot (a table over whole numbers) says
///   static constexpr bool dual_numbers = false;        // central differences
/// x is taken by value so that a small state stays in registers where the compiler does not inline.
template <class Model>
concept OdeModel = (Model::kStates > 0) && (Model::kInputs > 0) && (Model::kParameters > 0) &&
                   std::same_as<decltype(Model::default_parameters()),
                                Array<typename Model::Real, Model::kParameters>>;

template <class Model>
concept HasCoefficients = requires {
  typename Model::Coefficients;
};

template <class Model>
using OdeState = Array<typename Model::Real, Model::kStates>;
template <class Model>
using OdeInputs = Array<typename Model::Real, Model::kInputs>;
template <class Model>
using OdeParameterSet = Array<typename Model::Real, Model::kParameters>;

/// Model<Io> with another Io::Real; nothing for a model that is not a template over Io.
template <class Model, class OtherReal>
struct ModelOver {};
template <template <class> class Model, class Io, class OtherReal>
requires requires {
  typename Io::Real;
}
struct ModelOver<Model<Io>, OtherReal> {
  struct OtherIo : Io {
    using Real = OtherReal;
  };
  using type = Model<OtherIo>;
};

/// f(x) of a model with its parameters and input held constant, for the integrators.
template <OdeModel Model>
class OdeDerivative {
 public:
  constexpr OdeDerivative(const OdeParameterSet<Model>& parameters, const OdeInputs<Model>& input)
      : parameters_(parameters), input_(input) {}
  [[gnu::always_inline]] constexpr OdeState<Model> operator()(const OdeState<Model>& x) const {
    return Model::derivative(parameters_, input_, x);
  }

 private:
  OdeParameterSet<Model> parameters_;
  OdeInputs<Model> input_;
};

template <OdeModel Model>
requires HasCoefficients<Model>
class OdeDerivative<Model> {
 public:
  constexpr OdeDerivative(const OdeParameterSet<Model>& parameters, const OdeInputs<Model>& input)
      : coefficients_(Model::precompute(parameters, input)) {}
  [[gnu::always_inline]] constexpr OdeState<Model> operator()(const OdeState<Model>& x) const {
    return Model::derivative(coefficients_, x);
  }

 private:
  typename Model::Coefficients coefficients_;
};

}  // namespace eagerx::models
