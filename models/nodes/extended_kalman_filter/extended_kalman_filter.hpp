// An extended Kalman filter over the equations of an object.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <eagerx/rate.hpp>
#include <models/nodes/action_limits/per_element.hpp>
#include <models/nodes/block.hpp>
#include <models/nodes/extended_kalman_filter/ode_prediction.hpp>
#include <models/nodes/kalman_filter/covariance.hpp>

namespace eagerx::models {

/// x follows dx/dt = f(x, u, p) for a period, P := F·P·Fᵀ + Q, then for each element of measured,
/// one after the other, k = P·cᵀ/(c·P·cᵀ + r), x += k·(measured − c·x), P −= k·c·P. Elements that
/// are not finite or have not come correct nothing. If x or P is not finite, both begin anew.
template <class Io>
class ExtendedKalmanFilter {
 public:
  void reset(const typename Io::States& states) {
    begin();
    if constexpr (requires { states.x; }) {
      for (std::size_t i = 0; states.x && i < kOrder; ++i)
        x_[i] = static_cast<Real>(element(*states.x, i));
    }
  }

  void callback(const Tick& tick, const typename Io::Inputs& in, typename Io::Outputs& out) {
    if (tick.n > 0) predict(in);
    for (std::size_t i = 0; i < kMeasured; ++i) correct(in, i);
    if (!is_finite()) {
      begin();
      restarts_ += restarts_ != ~std::uint32_t{0} ? 1U : 0U;
    }
    for (std::size_t i = 0; i < kOrder; ++i) put(out.x, i, x_[i]);
  }

  template <class F>
  void for_each_count(F&& f) const {
    f("restarts", restarts_);
  }

 private:
  using Real = typename Io::Real;
  using Config = typename Io::Config;
  using Inputs = typename Io::Inputs;
  using Model = typename Config::model::Model;
  static_assert(OdeModel<Model>);
  static constexpr auto kOrder = static_cast<std::size_t>(Config::order);
  static constexpr std::size_t kMeasured = elements_of<decltype(Inputs::measured)>;
  static constexpr auto kC = constants<Real>(Config::c);
  static constexpr auto kTurn = constants<Real>(Config::turn);
  static constexpr auto kQ = constants<Real>(Config::q);
  static constexpr auto kR = constants<Real>(Config::r);
  static constexpr auto kP = constants<Real>(Config::p);
  static constexpr auto kInitial = constants<Real>(Config::initial);
  static constexpr auto kStep = constant<Real>(Io::Rate::period_s / Config::substeps);
  static_assert(kOrder == Model::kStates,
                "ExtendedKalmanFilter: `order` is the number of states of the model");
  static_assert(Config::parameters.size() == 0 || Config::parameters.size() == Model::kParameters,
                "ExtendedKalmanFilter: `parameters` has a value for each parameter of the model");
  static_assert(kC.size() == kOrder * kMeasured,
                "ExtendedKalmanFilter: `c` has `order` times as many values as `measured` has "
                "elements");
  static_assert(is_one_or_each(kTurn, kMeasured) && is_one_or_each(kR, kMeasured),
                "ExtendedKalmanFilter: `turn` and `r` have one value, or one for each element of "
                "`measured`");
  static_assert(is_one_or_each(kInitial, kOrder),
                "ExtendedKalmanFilter: `initial` has one value, or one for each state");

  static OdeParameterSet<Model> parameters() {
    OdeParameterSet<Model> p = Model::default_parameters();
    if constexpr (Config::parameters.size() > 0) {
      for (std::size_t i = 0; i < p.size(); ++i) p[i] = constant<Real>(Config::parameters[i]);
    }
    return p;
  }

  void begin() {
    for (std::size_t i = 0; i < kOrder; ++i) x_[i] = each<Real>(kInitial, i);
    p_.reset(kP);
  }

  void predict(const Inputs& in) {
    OdeInputs<Model> u{};
    if constexpr (requires { in.u; }) {
      static_assert(elements_of<decltype(in.u)> == Model::kInputs,
                    "ExtendedKalmanFilter: `u` has as many elements as the model has inputs");
      for (std::size_t i = 0; i < u.size(); ++i) {
        const Real input = newest<Real>(in.u, i);
        u[i] = eagerx::isfinite(input) ? input : Real(0);
      }
    }
    const OdeJacobian<Model> jacobian(parameters(), u);
    auto prediction = OdePrediction<Model>::from(x_);
    for (int i = 0; i < Config::substeps; ++i) prediction.step(jacobian, kStep);
    x_ = prediction.x;
    p_.predict(prediction.f, kQ);
  }

  void correct(const Inputs& in, std::size_t i) {
    const Real measured = newest<Real>(in.measured, i, FloatFormat<Real>::nan);
    if (!eagerx::isfinite(measured)) return;
    std::array<Real, kOrder> c;
    for (std::size_t k = 0; k < kOrder; ++k) c[k] = kC[i * kOrder + k];
    const auto gain = p_.update(c, each<Real>(kR, i), true);
    const Real difference = measured - row_times<Real>(kC, i, x_);
    const Real innovation = within_turn(difference, each<Real>(kTurn, i));
    for (std::size_t k = 0; k < kOrder; ++k) x_[k] += gain[k] * innovation;
  }

  [[nodiscard]] bool is_finite() const {
    bool finite = p_.is_finite();
    for (std::size_t i = 0; i < kOrder; ++i) finite = finite && eagerx::isfinite(x_[i]);
    return finite;
  }

  OdeState<Model> x_{};
  Covariance<Real, kOrder> p_{};
  std::uint32_t restarts_ = 0;
};

}  // namespace eagerx::models
