// The Rosenbrock method RODAS: fourth order, L-stable, for stiff equations, with an error estimate
// of third order that chooses the steps.
#pragma once

#include <array>
#include <cstddef>
#include <eagerx/math/vocabulary.hpp>
#include <eagerx/message.hpp>
#include <models/engines/ode_engine/lu.hpp>

namespace eagerx::models {

/// RODAS of Hairer, Wanner: Solving Ordinary Differential Equations II, 2nd edition, 1996, section
/// IV.7 and the coefficients of their program RODAS (METH=1), for dx/dt = f(x) without time:
///   (I/(γ·h) − J)·u_i = f(x + Σ_j a_ij·u_j) + Σ_j c_ij·u_j/h,   j < i, i = 1 … 6
/// The solution is x + Σ_j a_6j·u_j + u_6, its error is estimated by u_6.
/// Why this one: it solves linear systems only, so the work of a step is bounded (BDF and implicit
/// Runge-Kutta methods iterate); it has no past, so a new input at each tick costs nothing (BDF
/// begins anew with order 1); and order 4 fits odeint's tolerances of 2e-8 (ode23s has order 2).
template <class Lane>
struct Rodas4Coefficients {
  static constexpr std::size_t kStages = 6;
  static constexpr auto kGamma = Lane(0.25);
  /// Row i: the factors of u_1 … u_i in the argument of f in stage i + 2.
  static constexpr std::array<std::array<Lane, 5>, 5> kA = {{
      {Lane(1.544)},
      {Lane(0.9466785280815826), Lane(0.2557011698983284)},
      {Lane(3.314825187068521), Lane(2.896124015972201), Lane(0.9986419139977817)},
      {Lane(1.221224509226641), Lane(6.019134481288629), Lane(12.53708332932087),
       Lane(-0.6878860361058950)},
      {Lane(1.221224509226641), Lane(6.019134481288629), Lane(12.53708332932087),
       Lane(-0.6878860361058950), Lane(1)},
  }};
  static constexpr std::array<std::array<Lane, 5>, 5> kC = {{
      {Lane(-5.6688)},
      {Lane(-2.430093356833875), Lane(-0.2063599157091915)},
      {Lane(-0.1073529058151375), Lane(-9.594562251023355), Lane(-20.47028614809616)},
      {Lane(7.496443313967647), Lane(-10.24680431464352), Lane(-33.99990352819905),
       Lane(11.70890893206160)},
      {Lane(8.083246795921522), Lane(-7.981132988064893), Lane(-31.52159432874371),
       Lane(16.31930543123136), Lane(-6.058818238834054)},
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
