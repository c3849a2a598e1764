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
/// are not finite or missing correct nothing. If x or P is not finite, both are reset.
template <class Io>
class ExtendedKalmanFilter {
 public:
  void reset(const typename Io::States& states) {
    begin();
    if constexpr (requires { states.x; }) {
      for (std::size_t i = 0; states.x && i < kOrder; ++i)
        estimate_.x[i] = static_cast<Real>(element(*states.x, i));
    }
  }

  template <class AnyTick = Tick>
  void callback(const AnyTick& tick, const typename Io::Inputs& in, typename Io::Outputs& out) {
    change_where<Real>(!tick.is_first(), estimate_, [&] { predict(in); });
    for (std::size_t i = 0; i < kMeasured; ++i) correct(in, i);
    const TruthOf<Real> lost = !is_finite();
    change_where<Real>(lost, estimate_, [&] { begin(); });
    restarts_ += one_if<Real>(lost && restarts_ != Count(~std::uint32_t{0}));
    for (std::size_t i = 0; i < kOrder; ++i) put(out.x, i, estimate_.x[i]);
  }

  template <class F>
  void for_each_count(F&& f) const {
    f("restarts", static_cast<std::uint32_t>(restarts_));
  }

 private:
  using Real = typename Io::Real;
  using Count = CountOf<Real>;
  using Config = typename Io::Config;
  using Inputs = typename Io::Inputs;
  using Model = typename Config::model::Model;
  static_assert(OdeModel<Model>);
  static constexpr auto kOrder = static_cast<std::size_t>(Config::order);
  static constexpr std::size_t kMeasured = elements_of<decltype(Inputs::measured)>;
  static constexpr auto kC = constants<Real>(Config::c);
  static constexpr auto kTurn = constants<Real>(Config::turn);
  static constexpr auto kQ = factors_of<kOrder>(Config::q);
  static constexpr auto kR = constants<Real>(Config::r);
  static constexpr auto kP = factors_of<kOrder>(Config::p);
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
      for (std::size_t i = 0; i < p.size(); ++i) p[i] = Real(constant<Real>(Config::parameters[i]));
    }
    return p;
  }

  void begin() {
    for (std::size_t i = 0; i < kOrder; ++i) estimate_.x[i] = each<Real>(kInitial, i);
    estimate_.p.reset(kP);
  }

  void predict(const Inputs& in) {
    OdeInputs<Model> u{};
    if constexpr (requires { in.u; }) {
      static_assert(elements_of<decltype(in.u)> == Model::kInputs,
                    "ExtendedKalmanFilter: `u` has as many elements as the model has inputs");
      for (std::size_t i = 0; i < u.size(); ++i) {
        const Real input = newest<Real>(in.u, i);
        u[i] = select(eagerx::isfinite(input), input, Real(0));
      }
    }
    const OdeJacobian<Model> jacobian(parameters(), u);
    auto prediction = OdePrediction<Model>::from(estimate_.x);
    for (int i = 0; i < Config::substeps; ++i) prediction.step(jacobian, Real(kStep));
    estimate_.x = prediction.x;
    estimate_.p.predict(prediction.f, kQ);
  }

  void correct(const Inputs& in, std::size_t i) {
    const Real measured = newest<Real>(in.measured, i, Real(FloatFormat<LaneOf<Real>>::nan));
    change_where<Real>(eagerx::isfinite(measured), estimate_, [&] {
      std::array<Real, kOrder> c;
      for (std::size_t k = 0; k < kOrder; ++k) c[k] = Real(kC[i * kOrder + k]);
      const auto gain = estimate_.p.update(c, each<Real>(kR, i), TruthOf<Real>(true));
      const Real difference = measured - row_times<Real>(kC, i, estimate_.x);
      const Real innovation = within_turn(difference, each<LaneOf<Real>>(kTurn, i));
      for (std::size_t k = 0; k < kOrder; ++k) estimate_.x[k] += gain[k] * innovation;
    });
  }

  [[nodiscard]] TruthOf<Real> is_finite() const {
    TruthOf<Real> finite = estimate_.p.is_finite();
    for (std::size_t i = 0; i < kOrder; ++i) finite = finite && eagerx::isfinite(estimate_.x[i]);
    return finite;
  }

  struct Estimate {
    OdeState<Model> x{};
    Covariance<Real, kOrder> p{};
  };
  Estimate estimate_{};
  Count restarts_{};
};

}  // namespace eagerx::models
