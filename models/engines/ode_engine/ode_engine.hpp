// The engine that integrates ordinary differential equations.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/math.hpp>
#include <eagerx/message.hpp>
#include <eagerx/rate.hpp>
#include <limits>
#include <models/engines/ode_engine/adaptive.hpp>
#include <models/engines/ode_engine/adaptive_lanes.hpp>
#include <models/engines/ode_engine/dopri5.hpp>
#include <models/engines/ode_engine/ode_jacobian.hpp>
#include <models/engines/ode_engine/ode_model.hpp>
#include <models/engines/ode_engine/ode_simulator.hpp>
#include <models/engines/ode_engine/rk4.hpp>
#include <models/engines/ode_engine/rodas4.hpp>

namespace eagerx::models {

enum class OdeMethod : std::uint8_t { rk4, dopri5, rodas4 };

/// Advances every object's OdeSimulator by one period of the engine, with its input held constant.
///
/// No callback throws or stops. What could not be integrated as asked is counted in the simulator's
/// faults(), and the simulation continues, as EAGERx's does after odeint's warning:
///   dopri5 and rodas4, more than `mxstep` steps tried, or the tolerances not met in the shortest
///   step (also
///     because the derivative is NaN or infinite): the state is the last one that met the
///     tolerances. The object is then late by what was not integrated.
///   rk4: the state after the tick is not finite. It is published as it is.
template <class Io>
class OdeEngine {
 public:
  void reset(const typename Io::States& /*states*/) {}

  template <class... Simulators>
  void callback(const Tick& /*tick*/, Simulators&... simulators) {
    (advance(simulators), ...);
  }

 private:
  using Config = typename Io::Config;
  static constexpr std::uint32_t kDefaultMaxSteps = 500;  // odeint's, for mxstep 0

  template <class Simulator>
  static void advance(Simulator& simulator) {
    using Model = typename Simulator::Model;
    using Real = typename Simulator::Real;
    if constexpr (Config::method == OdeMethod::rk4) {
      const OdeDerivative<Model> derivative(simulator.parameters, simulator.input);
      advance_rk4(derivative, simulator);
    } else if constexpr (lanes<Real> == 1) {
      with_method<Model>(simulator.parameters, simulator.input,
                         [&](auto& method) { advance_adaptively(method, simulator); });
    } else {
      advance_lanes(simulator);
    }
  }

  /// f(method), which holds for these parameters and this input.
  template <class Model, class F>
  [[gnu::always_inline]] static void with_method(const OdeParameterSet<Model>& parameters,
                                                 const OdeInputs<Model>& input, const F& f) {
    using Real = typename Model::Real;
    if constexpr (Config::method == OdeMethod::rodas4) {
      const OdeJacobian<Model> jacobian(parameters, input);
      Rodas4<OdeJacobian<Model>, Real, Model::kStates> method(jacobian);
      f(method);
    } else {
      const OdeDerivative<Model> derivative(parameters, input);
      Dopri5<OdeDerivative<Model>, Real, Model::kStates> method(derivative);
      f(method);
    }
  }

  /// Flattened, because otherwise g++ at -O2 calls the equation four times per step, a third of the
  /// time (tests/bench/instructions).
  template <class Derivative, class Simulator>
  [[gnu::flatten]] static void advance_rk4(const Derivative& derivative, Simulator& simulator) {
    using Real = typename Simulator::Real;
    static_assert(Config::substeps >= 1, "OdeEngine: `substeps` must be at least 1");
    constexpr Real kStep = static_cast<Real>(Io::Rate::period_s / Config::substeps);
    auto x = simulator.state;
    for (int i = 0; i < Config::substeps; ++i) x = rk4_step(derivative, x, kStep);
    simulator.state = x;
    simulator.add_fault_if(!all_finite(x));
  }

  template <class Method, class Simulator>
  static void advance_adaptively(Method& method, Simulator& simulator) {
    using Real = typename Simulator::Real;
    // In read-only memory, where `eagerx-gen size --worst` finds the most tries.
    static constexpr auto kSettings = adaptive_settings<Real>();
    const auto outcome =
        integrate(method, simulator.state, kPeriod<Real>, simulator.step_s, kSettings);
    simulator.add_fault_if(outcome != AdaptiveOutcome::done);
  }

  template <class Simulator>
  static void advance_lanes(Simulator& simulator) {
    using Model = typename Simulator::Model;
    using Real = typename Simulator::Real;
    LaneSteps<Real, Model::kStates> at(simulator.state, kPeriod<Real>, simulator.step_s,
                                       adaptive_settings<LaneOf<Real>>());
    LaneProgress<Real> progress;
    finish<Model>(simulator.parameters, simulator.input, at, progress);
    simulator.state = at.x;
    simulator.step_s = at.next_step_s;
    simulator.add_fault_if(progress.failed);
  }

  /// Integrates the whole SIMD vector while more than half of the lanes continue, then these in a
  /// vector of half as many registers, and so on: some lanes take many times the steps of the
  /// others.
  template <class Model, class Real = typename Model::Real>
  static void finish(const OdeParameterSet<Model>& parameters, const OdeInputs<Model>& input,
                     LaneSteps<Real, Model::kStates>& at, LaneProgress<Real>& progress) {
    constexpr auto kLanes = static_cast<std::size_t>(lanes<Real>);
    using Narrow = Simd<LaneOf<Real>, kLanes / 2>;
    constexpr bool kNarrows = Real::kCount > 1 && requires {
      typename ModelOver<Model, Narrow>::type;
    };
    with_method<Model>(parameters, input, [&](auto& method) {
      take_steps(method, at, progress, kPeriod<Real>, adaptive_settings<LaneOf<Real>>(),
                 kNarrows ? kLanes / 2 : 0);
    });
    if constexpr (kNarrows) {
      using NarrowModel = typename ModelOver<Model, Narrow>::type;
      finish_few<Narrow>(at, progress, [&](const auto& chosen, auto& few) {
        OdeParameterSet<NarrowModel> of_few;
        OdeInputs<NarrowModel> input_of_few;
        gather<kLanes>(parameters, chosen, of_few);
        gather<kLanes>(input, chosen, input_of_few);
        LaneProgress<Narrow> those{.tries = progress.tries};
        finish<NarrowModel>(of_few, input_of_few, few, those);
        return those.failed;
      });
    }
  }

  template <class Real>
  static constexpr auto kPeriod = static_cast<LaneOf<Real>>(Io::Rate::period_s);

  /// The configuration with odeint's meaning of 0, and tolerances that Real can resolve.
  template <class Real>
  static constexpr AdaptiveSettings<Real> adaptive_settings() {
    constexpr auto kLeastRtol = 10.0 * static_cast<double>(std::numeric_limits<Real>::epsilon());
    constexpr auto kLeastAtol = static_cast<double>(std::numeric_limits<Real>::min());
    constexpr double kHmax = Config::hmax;
    static_assert(Config::hmin >= 0.0 && kHmax >= 0.0,
                  "OdeEngine: `hmin` and `hmax` must not be negative");
    static_assert(kHmax == 0.0 || Config::hmin <= kHmax,
                  "OdeEngine: `hmin` must not be above `hmax`");
    static_assert(Config::mxstep >= 0, "OdeEngine: `mxstep` must not be negative");
    return {
        .rtol = static_cast<Real>(eagerx::max(double{Config::rtol}, kLeastRtol)),
        .atol = static_cast<Real>(eagerx::max(double{Config::atol}, kLeastAtol)),
        .shortest_s = static_cast<Real>(Config::hmin),
        .longest_s = static_cast<Real>(kHmax > 0.0 ? kHmax : Io::Rate::period_s),
        .max_tries =
            Config::mxstep > 0 ? static_cast<std::uint32_t>(Config::mxstep) : kDefaultMaxSteps,
    };
  }

  template <class Real, std::size_t N>
  static constexpr TruthOf<Real> all_finite(const Array<Real, N>& x) {
    TruthOf<Real> finite = true;
    for (std::size_t i = 0; i < N; ++i) finite = finite && eagerx::isfinite(x[i]);
    return finite;
  }
};

}  // namespace eagerx::models
