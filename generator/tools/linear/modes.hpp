// The poles of a sampled system, and the loop that is opened at a port.
#pragma once

#include <complex>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "generator/tools/linear/sampled_system.hpp"

namespace eagerx::gen {

/// A share of a state in a pole: |v·w| of its right and left eigenvectors, of their sum.
struct Participation {
  std::size_t state = 0;
  double share = 0.0;
};

/// A pole of the map of a hyperperiod, or a conjugated pair: that with the positive imaginary part.
struct Pole {
  std::complex<double> z;
  double frequency_hz = 0.0;                 // |s|/2π of z = exp(s·T)
  double damping = 1.0;                      // -Re(s)/|s|; 1 for what decays without a swing
  double time_constant_s = 0.0;              // -1/Re(s); negative: it grows
  std::vector<Participation> participation;  // the largest shares first, at most three
};

struct Modes {
  double spectral_radius = 0.0;  // without integrators
  std::size_t integrators = 0;   // poles at 1: what nothing holds
  std::vector<Pole> poles;       // slowest first; those below |z| = 1e-6 are `at_zero`
  std::size_t at_zero = 0;       // what is passed on and forgotten: messages, delays
};
Modes modes_of(const SampledSystem& system);

/// Where the loop at the opened port comes nearest to instability. The loop is what comes back to
/// the port, with its sign changed: 1 + L = 0 is the limit. Nothing: at no frequency.
struct Margins {
  bool is_stable = false;                                     // the loop as it runs, closed
  double spectral_radius = 0;                                 // of it, without integrators
  std::size_t integrators = 0;                                // its poles at 1, which do not count
  double port_period_s = 0.0;                                 // of its messages
  std::optional<double> gain, gain_frequency_hz;              // factors above 1, the smallest
  std::optional<double> least_gain, least_gain_frequency_hz;  // factors below 1, the largest
  std::optional<double> phase_deg, crossover_hz;              // the smallest
  std::optional<double> delay_s, delay_frequency_hz;          // the smallest, if it is stable
  std::optional<std::size_t>
      stable_messages;             // more messages of delay, exactly; nothing: all tried
  std::size_t tried_messages = 0;  // with which it is stable, one after the other
  double sensitivity = 0.0, sensitivity_hz = 0.0;  // the largest |1/(1 + L)|
  double other_frequencies =
      0.0;  // what comes back at others, of what comes back, at the crossover
};
Margins margins_of(const SampledSystem& system);

/// L at a frequency.
struct Response {
  double frequency_hz = 0.0;
  std::complex<double> loop;
};
/// At `count` frequencies with equal ratios, up to half of the rate of the port's messages.
std::vector<Response> responses_of(const SampledSystem& system, std::size_t count);

/// Of the loop as it runs, closed: over a hyperperiod.
std::vector<std::complex<double>> closed_poles_of(const SampledSystem& system);

/// The closed loop after a unit step at the opened port, in one message.
struct StepSample {
  double time_s = 0.0;
  double sent = 0.0;      // what the readers of the port get: the step and what returns, S
  double returned = 0.0;  // what the loop does against it, T = 1 - S
};
/// Until the slowest pole has settled, at most 20,000 messages.
std::vector<StepSample> step_response_of(const SampledSystem& system);

}  // namespace eagerx::gen
