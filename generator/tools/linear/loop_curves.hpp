// What pictures show of the loop opened at a port.
#pragma once

#include <complex>
#include <string>
#include <vector>

#include "generator/support/json/json.hpp"
#include "generator/tools/linear/hyperperiod.hpp"
#include "generator/tools/linear/write.hpp"

namespace eagerx::gen {

/// L at a frequency.
struct BodePoint {
  double frequency_hz = 0.0, gain_db = 0.0;
  double phase_deg = 0.0;  // without jumps of a turn; -180 plus the phase margin at the crossover
  std::complex<double> loop;
};

/// The step response of the program that was linearized, of a step of this size.
struct SimulatedStep {
  double size = 0.0;             // 0: there is none
  std::string unit;              // of the port
  std::vector<StepSample> step;  // divided by the size; shorter than that of the linear model where
                                 // the program diverges
  double difference = 0.0;       // from the linear model: the largest of `returned`
};

struct LoopCurves {
  std::string port;
  Margins margins;
  std::vector<BodePoint> bode;  // equal ratios of frequencies, up to half the port's rate
  std::vector<std::complex<double>> open_poles, closed_poles;  // z, over a hyperperiod
  std::vector<StepSample> step;                                // at most 600
  std::size_t stride = 1;  // of messages, from one of `step` to the next
  SimulatedStep simulated;
};
/// Needs `report.margins`.
LoopCurves loop_curves_of(const LinearReport& report);

/// Messages that the step response covers.
std::size_t step_messages(const LoopCurves& curves);
/// Adds what the program sent at the port with a step of this size and without it, by message.
void add_simulated_step(const std::vector<double>& with, const std::vector<double>& without,
                        double size, const std::string& unit, LoopCurves& curves);

/// For the page: numbers with six digits.
Json loop_curves_json(const LoopCurves& curves);

/// The parameters that a reset sets, for sliders: `[{name, values, low, high}]` with an element of
/// each list for each number; null: no bound.
Json parameters_json(const Hyperperiod& there);

}  // namespace eagerx::gen
