// The interface of each node of graph `multi_rate`: rate, parameters, inputs, outputs.
// Made by eagerx-gen 1.0.0 from graph.yaml. Do not edit: change the graph and generate again.
#pragma once

#include <array>
#include <cstdint>
#include <models/nodes/butterworth_filter/butterworth_filter.hpp>
#include <models/processors/decomposed_angle/decomposed_angle.hpp>
#include <models/processors/negate/negate.hpp>

#include "multi_rate/messages.hpp"

namespace graphs::multi_rate {

/// The number type of engines and nodes.
using Real = double;

/// Numbers of the published messages in the trace.
namespace channel {
inline constexpr std::uint32_t engine_tick = 0;
inline constexpr std::uint32_t environment_push = 1;
inline constexpr std::uint32_t environment_voltage = 2;
inline constexpr std::uint32_t fast_filtered = 3;
inline constexpr std::uint32_t left_theta_observation = 4;
inline constexpr std::uint32_t left_theta_dot_observation = 5;
inline constexpr std::uint32_t left_u_action_applied = 6;
inline constexpr std::uint32_t left_u_applied_action_applied = 7;
inline constexpr std::uint32_t left_x_observation = 8;
inline constexpr std::uint32_t right_theta_observation = 9;
inline constexpr std::uint32_t right_u_action_applied = 10;
inline constexpr std::uint32_t right_u_applied_action_applied = 11;
inline constexpr std::uint32_t right_x_observation = 12;
inline constexpr std::uint32_t slow_filtered = 13;
}  // namespace channel

// observations.angle: DecomposedAngle
struct ObservationAngleProcessorIo {
  using Real = graphs::multi_rate::Real;
  using Input = float;
  using Output = eagerx::Array<float, 2>;
  struct Config {};
};
using ObservationAngleProcessor = eagerx::models::DecomposedAngle<ObservationAngleProcessorIo>;

// fast.filtered: Negate
struct FastFilteredProcessorIo {
  using Real = graphs::multi_rate::Real;
  using Input = eagerx::Array<float, 1>;
  using Output = eagerx::Array<float, 1>;
  struct Config {};
};
using FastFilteredProcessor = eagerx::models::Negate<FastFilteredProcessorIo>;

// fast: ButterworthFilter at 30 Hz
struct FastIo {
  using Real = graphs::multi_rate::Real;
  using Rate = eagerx::Rate<30>;
  struct Config {
    static constexpr int order = 3;
    static constexpr auto type = eagerx::models::FilterType::bandpass;
    static constexpr std::array<double, 2> cutoff_hz = {2.0, 9.0};  // Hz
    static constexpr auto initial = eagerx::models::FilterInitial::zero;
  };
  struct Inputs {
    eagerx::Window<eagerx::Array<float, 1>, eagerx::Rate<10>, 4, 3, false> signal;  // float32 [1]

    template <class F>
    void for_each(F&& f) const {
      f("signal", this->signal);
    }
  };
  struct Outputs {
    eagerx::Array<float, 1>& filtered;
  };
  struct States {};
};

}  // namespace graphs::multi_rate
