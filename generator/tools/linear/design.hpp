// Gains of controllers and observers, for the plant as their node sees it.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "generator/graph/plan/plan.hpp"
#include "generator/tools/linear/sampled_system.hpp"

namespace eagerx::gen {

/// The problem with what the program has printed.
inline constexpr const char* kNoMatrices = "the program has printed no matrices";

/// An element of what the node receives or sends, of another port, or a number of the state, with
/// the deviation that is tolerable, or the standard deviation of its noise.
struct Deviation {
  enum class Of : unsigned char { received, port, state };
  Of of = Of::received;
  std::string name;         // of the input; of a state its own
  std::size_t element = 0;  // of an input or a port
  std::size_t port = 0;     // which of the further ports
  double value = 1.0;
};

/// A number of the state that helps to find what the regulator of the whole state would send.
struct MissingState {
  std::string name;
  double share = 0.0;  // of what the received numbers leave unknown
};

struct LqrRequest {
  std::vector<Deviation> deviations;
  std::vector<std::size_t> port_sizes;  // elements of the messages of each further port
  std::vector<double> efforts;          // of the elements that the node sends
  std::vector<double> gain;             // that it has, row after row
};
struct LqrDesign {
  std::string problem, help;  // if there are no gains
  Rows gain;                  // [sent][received], u = -gain·received
  double unknown = 0.0;       // of the full regulator's output, what the inputs do not determine
  double cost = 1.0;          // of the full regulator's
  std::vector<MissingState> missing;
  std::vector<std::string> free;  // states that cost nothing, change no gain, and do not decay
  std::vector<std::string> losing, smoothing;
};
/// Least in cost Σ (deviation/tolerable)² + (output/effort)² with white noise of one effort at the
/// node's output: the regulator of the whole state (Bryson, Ho: Applied Optimal Control, 1975)
/// where the inputs of the node determine it; else the constant gain of the inputs that costs
/// least. It begins with the best estimate of the full regulator's output (Kosut, IEEE Trans.
/// Automatic Control 15 (1970), 557-563) and descends to where the gradient vanishes (Levine,
/// Athans, same journal, 44-48). `input`: of the node, whose elements have gains.
LqrDesign design_lqr(std::string_view printed, const Plan& plan, const std::string& input,
                     const LqrRequest& request);

struct KalmanModel {
  std::size_t order = 0;
  std::vector<double> a, b, c;  // row after row
};
struct KalmanRequest {
  KalmanModel model;
  std::vector<std::string> state;  // its names; empty: x[0], …
  std::vector<double> process;     // standard deviations of each state at a tick
  std::vector<double> input;       // and of each input
  std::vector<double> measured;    // and of each measurement
};
struct KalmanDesign {
  std::string problem, help;
  std::vector<double> q, r, gain;  // q: the diagonal, or row after row
  std::vector<double> deviations;  // of the estimate of each state, standard
  double spectral_radius = 0.0;    // of the errors, from tick to tick
};
/// The filter in its steady state, that of KalmanFilter and Observer: prediction, then correction.
KalmanDesign design_kalman(const KalmanRequest& request);

/// The model of a filter from the graph: from its input `u` to its input `measured`.
struct ModelDesign {
  std::string problem, help;
  KalmanModel model;
  std::vector<std::string> state;
  std::vector<double> values;  // of the state, where it was linearized
  std::vector<std::string> losing, smoothing;
};
ModelDesign model_of(std::string_view printed, const Plan& plan);

struct PidRequest {
  enum class Terms : unsigned char { p, pi, pd, pid };
  Terms terms = Terms::pi;
  std::optional<double> crossover_hz;  // without: that with the largest gain of the integral
  double phase_deg = 60.0;
};
struct PidDesign {
  std::string problem, help;
  double kp = 0.0, ki = 0.0, kd = 0.0;
  double crossover_hz = 0.0, phase_deg = 0.0;
  std::vector<std::string> losing, smoothing;
};
/// Gains that put L at its crossover where the phase margin asks for it: two equations for two
/// gains that L depends on linearly, exact at the node's rate; of three gains the integral's time
/// is four times the derivative's. Åström, Hägglund: Advanced PID Control, 2006, chapter 6.
PidDesign design_pid(std::string_view printed, const Plan& plan, const PidRequest& request);

}  // namespace eagerx::gen
