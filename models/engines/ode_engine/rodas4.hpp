// The Rosenbrock method RODAS4P: fourth order, L-stable, for stiff equations, with an error
// estimate of third order that chooses the steps.
#pragma once

#include <array>
#include <cstddef>
#include <eagerx/math/vocabulary.hpp>
#include <eagerx/message.hpp>
#include <models/engines/ode_engine/lu.hpp>

namespace eagerx::models {

/// RODAS4P of Steinebach: Order-reduction of ROW-methods for DAEs and method of lines applications,
/// TH Darmstadt, preprint 1741, 1995 (METH=3 in the program RODAS of Hairer, Wanner: Solving
/// Ordinary Differential Equations II, 2nd edition, 1996, section IV.7), for dx/dt = f(x) without
/// time:
///   (I/(γ·h) − J)·u_i = f(x + Σ_j a_ij·u_j) + Σ_j c_ij·u_j/h,   j < i, i = 1 … 6
/// The solution is x + Σ_j a_6j·u_j + u_6, its error is estimated by u_6.
/// Why this one: it solves linear systems only, so the work of a step is bounded (BDF and implicit
/// Runge-Kutta methods iterate); it has no past, so a new input at each tick costs nothing (BDF
/// begins anew with order 1); and order 4 fits odeint's tolerances of 2e-8 (ode23s has order 2).
/// Why these coefficients: with those of METH=1, the order drops to 2 where the equations are much
/// stiffer than the tolerance is tight. Van der Pol's equation with mu = 1000 then takes 2.4 times
/// the steps for each decade of the tolerance, with these 1.9 times (the order says 1.8).
template <class Lane>
struct Rodas4Coefficients {
  static constexpr std::size_t kStages = 6;
  static constexpr auto kGamma = Lane(0.25);
  /// Row i: the factors of u_1 … u_i in the argument of f in stage i + 2.
  static constexpr std::array<std::array<Lane, 5>, 5> kA = {{
      {Lane(3)},
      {Lane(1.831036793486759), Lane(0.4955183967433795)},
      {Lane(2.304376582692669), Lane(-0.05249275245743001), Lane(-1.176798761832782)},
      {Lane(-7.170454962423024), Lane(-4.741636671481785), Lane(-16.31002631330971),
       Lane(-1.062004044111401)},
      {Lane(-7.170454962423024), Lane(-4.741636671481785), Lane(-16.31002631330971),
       Lane(-1.062004044111401), Lane(1)},
  }};
  static constexpr std::array<std::array<Lane, 5>, 5> kC = {{
      {Lane(-12)},
      {Lane(-8.791795173947035), Lane(-2.207865586973518)},
      {Lane(10.81793056857153), Lane(6.780270611428266), Lane(19.53485944642410)},
      {Lane(34.19095006749676), Lane(15.49671153725963), Lane(54.74760875964130),
       Lane(14.16005392148534)},
      {Lane(34.62605830930532), Lane(15.30084976114473), Lane(56.99955578662667),
       Lane(18.40807009793095), Lane(-5.714285714285717)},
  }};
};

/// One step of `step_s` seconds from a state `x` [N], with slope = f(x) and `jacobian` = ∂f/∂x at
/// x, row-major [N][N].
template <class Real, std::size_t N>
struct Rodas4Step {
  using State = Array<Real, N>;
  State end{};    // x after the step, fourth order
  State error{};  // difference to the embedded method of third order

  template <class F>
  constexpr Rodas4Step(const F& f, const State& x, const State& slope,
                       const std::array<Real, N * N>& jacobian, Real step_s) {
    using Coefficients = Rodas4Coefficients<LaneOf<Real>>;
    const Lu<Real, N> w = shifted(jacobian, Real(1) / (Real(Coefficients::kGamma) * step_s));
    std::array<State, Coefficients::kStages> u{};
    u[0] = w.solve(slope);
    for (std::size_t stage = 1; stage < u.size(); ++stage) {
      end = x;
      State right{};
      for (std::size_t j = 0; j < stage; ++j) {
        const Real a(Coefficients::kA[stage - 1][j]);
        const Real c = Real(Coefficients::kC[stage - 1][j]) / step_s;
        for (std::size_t i = 0; i < N; ++i) {
          end[i] += a * u[j][i];
          right[i] += c * u[j][i];
        }
      }
      const State here = f(end);
      for (std::size_t i = 0; i < N; ++i) right[i] += here[i];
      u[stage] = w.solve(right);
    }
    error = u.back();
    for (std::size_t i = 0; i < N; ++i) end[i] += error[i];
  }

 private:
  /// diagonal·I − jacobian
  static constexpr Lu<Real, N> shifted(const std::array<Real, N * N>& jacobian, Real diagonal) {
    std::array<Real, N * N> w{};
    for (std::size_t i = 0; i < w.size(); ++i) w[i] = -jacobian[i];
    for (std::size_t i = 0; i < N; ++i) w[i * N + i] += diagonal;
    return Lu<Real, N>(w);
  }
};

/// The method for `integrate`. `Jacobian` gives dx/dt [N] as slope(x), and ∂f/∂x, row-major [N][N],
/// as operator()(x). It is computed once for each step that was taken, the factors for each step
/// that is tried.
template <class Jacobian, class Real, std::size_t N>
class Rodas4 {
 public:
  static constexpr int kErrorOrder = 4;
  constexpr explicit Rodas4(const Jacobian& jacobian) : jacobian_(jacobian) {}
  constexpr void begin(const Array<Real, N>& x) {
    slope_ = jacobian_.slope(x);
    matrix_ = jacobian_(x);
  }
  constexpr auto step(const Array<Real, N>& x, Real step_s) const {
    const auto f = [&](const Array<Real, N>& at) { return jacobian_.slope(at); };
    return Rodas4Step<Real, N>(f, x, slope_, matrix_, step_s);
  }
  constexpr void go_on(const Rodas4Step<Real, N>& step) { begin(step.end); }
  constexpr void go_on(const Rodas4Step<Real, N>& /*step*/, const Array<Real, N>& x,
                       const TruthOf<Real>& /*taken*/) {
    begin(x);  // where no step was taken, this is what it was
  }

 private:
  const Jacobian& jacobian_;
  Array<Real, N> slope_{};
  std::array<Real, N * N> matrix_{};
};

}  // namespace eagerx::models
