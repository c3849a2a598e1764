// Gains of a PidController for a crossover and a phase margin of its loop.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>

#include "generator/tools/linear/design.hpp"
#include "generator/tools/linear/matrices.hpp"
#include "generator/tools/linear/node_plant.hpp"
#include "generator/tools/linear/riccati.hpp"

namespace eagerx::gen {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXd;
constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr double kDegrees = 360.0 / kTurn;

/// What each term makes of the loop at a frequency: L = kp·p + ki·i + kd·d + rest.
struct Terms {
  double w = 0.0;
  Complex p, i, d, rest;
};
struct Gains {
  double kp = 0.0, ki = 0.0, kd = 0.0;
  [[nodiscard]] Complex loop(const Terms& at) const {
    return kp * at.p + ki * at.i + kd * at.d + at.rest;
  }
};

/// The rows of what is received that a PidController reads; -1: there is none.
struct PidInputs {
  Index measured = -1, derivative = -1, setpoint = -1, feed_forward = -1;
};
PidInputs inputs_of(const NodePlant& plant) {
  PidInputs inputs;
  for (std::size_t i = 0; i < plant.received.size(); ++i) {
    const std::string& name = plant.received[i].input;
    const auto row = static_cast<Index>(i);
    if (name == "measured") inputs.measured = row;
    if (name == "derivative") inputs.derivative = row;
    if (name == "setpoint") inputs.setpoint = row;
    if (name == "feed_forward") inputs.feed_forward = row;
  }
  return inputs;
}

/// The plant at frequencies: what comes of a sine of the output, of the same frequency.
class PlantResponse {
 public:
  explicit PlantResponse(const NodePlant& plant) : plant_(plant), inputs_(inputs_of(plant)) {
    std::vector<MatrixXd> maps;
    for (const PlantPhase& phase : plant.phases) maps.push_back(phase.a);
    monodromy_ = monodromy(maps).cast<Complex>();
  }

  [[nodiscard]] Terms at(double w) const {
    const double h = plant_.period_s;
    const Complex z = std::polar(1.0, w * h);
    const Eigen::VectorXcd received = response(z);
    const auto of = [&](Index row) { return row < 0 ? Complex(0.0) : received[row]; };
    Terms terms;
    terms.w = w;
    terms.p = of(inputs_.measured) - of(inputs_.setpoint);
    terms.i = terms.p * h / (1.0 - 1.0 / z);
    terms.d = inputs_.derivative < 0 ? of(inputs_.measured) * (1.0 - 1.0 / z) / h
                                     : of(inputs_.derivative);
    terms.rest = -of(inputs_.feed_forward);
    return terms;
  }

 private:
  [[nodiscard]] Eigen::VectorXcd response(Complex z) const {
    const Index n = monodromy_.rows();
    Eigen::VectorXcd forced = Eigen::VectorXcd::Zero(n);
    Complex turn = 1.0;
    for (const PlantPhase& phase : plant_.phases) {
      forced = (phase.a.cast<Complex>() * forced + phase.b.col(0).cast<Complex>() * turn).eval();
      turn *= z;
    }
    const Eigen::MatrixXcd whole = turn * Eigen::MatrixXcd::Identity(n, n) - monodromy_;
    Eigen::VectorXcd x = whole.partialPivLu().solve(forced);
    Eigen::VectorXcd sum = Eigen::VectorXcd::Zero(plant_.phases.front().c.rows());
    turn = 1.0;
    for (const PlantPhase& phase : plant_.phases) {
      sum += phase.c.cast<Complex>() * x / turn;
      x = (phase.a.cast<Complex>() * x + phase.b.col(0).cast<Complex>() * turn).eval();
      turn *= z;
    }
    return sum / static_cast<double>(plant_.phases.size());
  }

  const NodePlant& plant_;
  PidInputs inputs_;
  Eigen::MatrixXcd monodromy_;
};

/// The spectral radius of the closed loop, over all phases, without integrators. Its state is that
/// of the plant, the sum of the integral, and `measured` of the tick before.
double closed_radius(const NodePlant& plant, const Gains& gains) {
  const PidInputs inputs = inputs_of(plant);
  const Index n = plant.phases.front().a.rows();
  const double h = plant.period_s;
  std::vector<MatrixXd> maps;
  for (const PlantPhase& phase : plant.phases) {
    const auto row = [&](Index of) {
      Eigen::RowVectorXd whole = Eigen::RowVectorXd::Zero(n + 2);
      if (of >= 0) whole.head(n) = phase.c.row(of);
      return whole;
    };
    const Eigen::RowVectorXd measured = row(inputs.measured);
    const Eigen::RowVectorXd error = row(inputs.setpoint) - measured;
    Eigen::RowVectorXd change = row(inputs.derivative);
    if (inputs.derivative < 0) change = (measured - Eigen::RowVectorXd::Unit(n + 2, n + 1)) / h;
    const Eigen::RowVectorXd sum = Eigen::RowVectorXd::Unit(n + 2, n) + gains.ki * h * error;
    const Eigen::RowVectorXd u =
        gains.kp * error + sum - gains.kd * change + row(inputs.feed_forward);
    MatrixXd map = MatrixXd::Zero(n + 2, n + 2);
    map.topLeftCorner(n, n) = phase.a;
    map.topRows(n) += phase.b.col(0) * u;
    map.row(n) = sum;
    map.row(n + 1) = measured;
    maps.push_back(std::move(map));
  }
  return spectral_radius(poles_of(monodromy(maps)));
}

class PidDesigner {
 public:
  PidDesigner(NodePlant plant, const PidRequest& request)
      : plant_(std::move(plant)), request_(request) {}

  PidDesign run() {
    result_.losing = plant_.losing;
    result_.smoothing = plant_.smoothing;
    reduce(plant_, Kept::reached);
    if (plant_.state.empty() || plant_.inputs() != 1) return no_response();
    const PlantResponse response(plant_);
    last_ = std::numbers::pi / plant_.period_s;
    for (std::size_t i = 0; i < kFrequencies; ++i) {
      const double part = static_cast<double>(i) / static_cast<double>(kFrequencies);
      grid_.push_back(response.at(last_ * std::pow(10.0, -kDecades * (1.0 - part))));
    }
    const bool responds =
        std::ranges::any_of(grid_, [](const Terms& at) { return std::abs(at.p) > 0.0; });
    if (!responds) return no_response();
    if (!request_.crossover_hz) return fastest();
    const double w = *request_.crossover_hz * kTurn;
    if (w >= last_) {
      result_.problem = fmt::format(
          "a crossover at {:.6g} Hz is not below half of the node's rate, "
          "{:.6g} Hz",
          *request_.crossover_hz, last_ / kTurn);
      return std::move(result_);
    }
    const Terms at = response.at(w);
    for (const Gains& gains : solutions(at)) {
      if (refusal(gains, at).empty()) return take(gains, at);
    }
    return refuse(at);
  }

 private:
  static constexpr std::size_t kFrequencies = 1500;
  static constexpr double kDecades = 5.0;

  PidDesign no_response() {
    result_.problem = "what the node measures does not respond to its output";
    result_.help =
        "connect its output to the plant, and choose a point at which no limit holds "
        "it: `--at`";
    return std::move(result_);
  }
  PidDesign take(const Gains& gains, const Terms& at) {
    result_.kp = gains.kp;
    result_.ki = gains.ki;
    result_.kd = gains.kd;
    result_.crossover_hz = at.w / kTurn;
    result_.phase_deg = request_.phase_deg;
    return std::move(result_);
  }

  /// Where L must be: -exp(j·phase).
  [[nodiscard]] Complex wanted() const { return -std::polar(1.0, request_.phase_deg / kDegrees); }

  /// Gains with L = wanted() at a frequency; with P alone those with |L| = 1 there.
  [[nodiscard]] std::vector<Gains> solutions(const Terms& at) const {
    const Complex target = wanted() - at.rest;
    switch (request_.terms) {
      case PidRequest::Terms::p: {
        // |kp·p + rest| = 1
        const double square = std::norm(at.p), both = std::real(std::conj(at.p) * at.rest);
        const double inner = both * both - square * (std::norm(at.rest) - 1.0);
        if (!(inner >= 0.0) || square == 0.0) return {};
        return {{(-both + std::sqrt(inner)) / square}, {(-both - std::sqrt(inner)) / square}};
      }
      case PidRequest::Terms::pi: {
        const auto pair = two(at.p, at.i, target);
        return {{pair[0], pair[1], 0.0}};
      }
      case PidRequest::Terms::pd: {
        const auto pair = two(at.p, at.d, target);
        return {{pair[0], 0.0, pair[1]}};
      }
      case PidRequest::Terms::pid:
        return with_all(at, target);
    }
    return {};
  }
  /// x·a + y·b = target.
  static std::array<double, 2> two(Complex a, Complex b, Complex target) {
    const double determinant = a.real() * b.imag() - a.imag() * b.real();
    return {(target.real() * b.imag() - target.imag() * b.real()) / determinant,
            (a.real() * target.imag() - a.imag() * target.real()) / determinant};
  }
  /// Ti = 4·Td: kp² = 4·ki·kd, of the line of solutions that kd leads along.
  [[nodiscard]] std::vector<Gains> with_all(const Terms& at, Complex target) const {
    const auto begin = two(at.p, at.i, target), slope = two(at.p, at.i, -at.d);
    const double a = slope[0] * slope[0] - 4.0 * slope[1];
    const double b = 2.0 * begin[0] * slope[0] - 4.0 * begin[1], c = begin[0] * begin[0];
    const double inner = b * b - 4.0 * a * c;
    if (!(inner >= 0.0) || a == 0.0) return {};
    std::vector<Gains> all;
    for (const double sign : {-1.0, 1.0}) {
      const double kd = (-b + sign * std::sqrt(inner)) / (2.0 * a);
      all.push_back({begin[0] + slope[0] * kd, begin[1] + slope[1] * kd, kd});
    }
    return all;
  }

  /// Why gains are not to be used; empty: they are.
  [[nodiscard]] std::string refusal(const Gains& gains, const Terms& at) const {
    if (!std::isfinite(gains.kp) || !std::isfinite(gains.ki) || !std::isfinite(gains.kd))
      return "no gains put the loop there";
    if (gains.ki * gains.kp < 0.0 || gains.kd * gains.kp < 0.0 || gains.kp == 0.0)
      return "it needs gains of both signs";
    const double phase = least_phase_deg(gains, at);
    if (phase < request_.phase_deg - kTolerance)
      return fmt::format("its phase margin is {:.4g} deg", phase);
    const double radius = closed_radius(plant_, gains);
    if (!(radius < 1.0))
      return fmt::format("the closed loop is unstable, spectral radius {:.6g}", radius);
    return {};
  }
  /// The smallest of all crossovers, and that at `at`.
  [[nodiscard]] double least_phase_deg(const Gains& gains, const Terms& at) const {
    double least = std::abs(std::arg(-gains.loop(at))) * kDegrees;
    Complex before = gains.loop(grid_.front());
    for (const Terms& each : grid_) {
      const Complex now = gains.loop(each);
      if ((std::abs(before) > 1.0) != (std::abs(now) > 1.0)) {
        // Between two frequencies: at the part of the way at which its logarithm is 0.
        const double from = std::log(std::abs(before)), to = std::log(std::abs(now));
        const double turned = std::arg(now / before);
        const double phase =
            std::abs(std::arg(-before * std::polar(1.0, turned * from / (from - to))));
        least = std::min(least, phase * kDegrees);
      }
      before = now;
    }
    return least;
  }

  /// The integral with the largest gain rejects disturbances best (Åström, Panagopoulos, Hägglund,
  /// Automatica 34 (1998), 585-601); without one the fastest crossover.
  struct Found {
    Gains gains;
    Terms at;
  };
  [[nodiscard]] std::optional<Found> best() const {
    std::optional<Found> found;
    const bool integrates =
        request_.terms == PidRequest::Terms::pi || request_.terms == PidRequest::Terms::pid;
    for (const Terms& at : grid_) {
      for (const Gains& gains : solutions(at)) {
        if (found && integrates && std::abs(gains.ki) <= std::abs(found->gains.ki)) continue;
        if (refusal(gains, at).empty()) found = Found{gains, at};
      }
    }
    return found;
  }
  PidDesign fastest() {
    if (const auto found = best()) return take(found->gains, found->at);
    result_.problem = fmt::format("{} reaches a phase margin of {:.6g} deg at no frequency",
                                  name_of_terms(), request_.phase_deg);
    result_.help = "ask for a smaller margin, or use other `--terms`";
    return std::move(result_);
  }
  PidDesign refuse(const Terms& at) {
    std::string why = "no gains put the loop there";
    for (const Gains& gains : solutions(at)) why = refusal(gains, at);
    const double lag = std::arg(at.p) * kDegrees;
    result_.problem = fmt::format(
        "{} does not reach a phase margin of {:.6g} deg with a crossover at {:.6g} Hz, where the "
        "plant's phase is {:.4g} deg: {}",
        name_of_terms(), request_.phase_deg, at.w / kTurn, lag, why);
    std::optional<double> fastest_hz;
    for (const Terms& each : grid_) {
      for (const Gains& gains : solutions(each)) {
        if (refusal(gains, each).empty()) fastest_hz = each.w / kTurn;
      }
    }
    result_.help =
        fastest_hz
            ? fmt::format("the fastest crossover with this margin is about {:.4g} Hz", *fastest_hz)
            : "no crossover has this margin: ask for a smaller one, or use other `--terms`";
    return std::move(result_);
  }
  [[nodiscard]] const char* name_of_terms() const {
    switch (request_.terms) {
      case PidRequest::Terms::p:
        return "P";
      case PidRequest::Terms::pi:
        return "PI";
      case PidRequest::Terms::pd:
        return "PD";
      case PidRequest::Terms::pid:
        return "PID";
    }
    return "";
  }

  static constexpr double kTolerance = 0.05;  // deg: crossovers between frequencies are estimated

  NodePlant plant_;
  const PidRequest& request_;
  double last_ = 0.0;  // half of the rate, in rad/s
  std::vector<Terms> grid_;
  PidDesign result_;
};

}  // namespace

PidDesign design_pid(std::string_view printed, const Plan& plan, const PidRequest& request) {
  auto plant = read_plant(printed, plan);
  if (!plant) {
    PidDesign result;
    result.problem = kNoMatrices;
    return result;
  }
  return PidDesigner(std::move(*plant), request).run();
}

}  // namespace eagerx::gen
