// What pictures show of the loop opened at a port.
#pragma once

#include <complex>
#include <string>
#include <vector>

#include "generator/support/json/json.hpp"
#include "generator/tools/linear/write.hpp"

namespace eagerx::gen {

/// L at a frequency.
struct BodePoint {
  double frequency_hz = 0.0, gain_db = 0.0;
  double phase_deg = 0.0;  // without jumps of a turn, from -180 to 180 at the lowest frequency
  std::complex<double> loop;
};

struct LoopCurves {
  std::string port;
  Margins margins;
  std::vector<BodePoint> bode;  // equal ratios of frequencies, up to half the port's rate
  std::vector<std::complex<double>> open_poles, closed_poles;  // z, over a hyperperiod
  std::vector<StepSample> step;                                // at most 600
};
/// Needs `report.margins`.
LoopCurves loop_curves_of(const LinearReport& report);

/// For the page: numbers with six digits.
Json loop_curves_json(const LoopCurves& curves);

}  // namespace eagerx::gen
