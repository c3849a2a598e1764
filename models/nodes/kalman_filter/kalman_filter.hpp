// A Kalman filter of a linear system.
#pragma once

#include <array>
#include <cstddef>
#include <eagerx/rate.hpp>
#include <models/nodes/kalman_filter/covariance.hpp>
#include <models/nodes/observer/linear_model.hpp>

namespace eagerx::models {

/// x := A·x + B·u, P := A·P·Aᵀ + Q, then for each element of measured, one after the other,
/// k = P·cᵀ/(c·P·cᵀ + r), x += k·(measured − c·x), P −= k·c·P. Elements that are not finite
/// or are missing correct nothing. If x or P is not finite, both begin anew.
template <class Io>
class KalmanFilter {
 public:
  void reset(const typename Io::States& states) {
    model_.reset(states);
    p_.reset(kP);
  }

  template <class AnyTick = Tick>
  void callback(const AnyTick& tick, const typename Io::Inputs& in, typename Io::Outputs& out) {
    change_where<Real>(!tick.is_first(), model_, [&] { model_.predict(in); });
    change_where<Real>(!tick.is_first(), p_, [&] { p_.predict(constant_matrix(), kQ); });
    for (std::size_t i = 0; i < Model::kMeasured; ++i) {
      std::array<Real, kOrder> c;
      for (std::size_t k = 0; k < kOrder; ++k) c[k] = Real(Model::kC[i * kOrder + k]);
      const auto gain = p_.update(c, each<Real>(kR, i), Model::is_measured(in, i));
      const Real innovation = model_.innovation(in, i);
      for (std::size_t k = 0; k < kOrder; ++k) model_.x.add(k, gain[k] * innovation);
    }
    const TruthOf<Real> lost = !(model_.x.is_finite() && p_.is_finite());
    change_where<Real>(lost, model_, [&] { model_.begin(); });
    change_where<Real>(lost, p_, [&] { p_.reset(kP); });
    for (std::size_t i = 0; i < kOrder; ++i) put(out.x, i, model_.x.x[i].value);
  }

 private:
  using Real = typename Io::Real;
  using Model = LinearModel<Io>;
  static constexpr std::size_t kOrder = Model::kOrder;
  static constexpr auto kQ = factors_of<kOrder>(Io::Config::q);
  static constexpr auto kR = constants<Real>(Io::Config::r);
  static_assert(kR.size() == 1 || kR.size() == Model::kMeasured,
                "KalmanFilter: `r` has one value, or one for each element of `measured`");
  static constexpr auto kP = factors_of<kOrder>(Io::Config::p);

  static auto constant_matrix() {
    std::array<Real, kOrder * kOrder> a;
    for (std::size_t i = 0; i < a.size(); ++i) a[i] = Real(Model::kA[i]);
    return a;
  }

  Model model_{};
  Covariance<Real, kOrder> p_{};
};

}  // namespace eagerx::models
