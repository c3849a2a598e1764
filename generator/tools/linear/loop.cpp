// Margins of the loop that is opened at a port.
//
// With several messages a hyperperiod the port's signal is a vector of them (lifting): y = G(z)·u.
// A sine at the port comes back as that sine, which is L, and as others if the loop between two
// messages is not the same for each: those are compared with it. Whether the loop is stable, and
// with how many more messages of delay, is exact either way: the eigenvalues of the closed map.
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "generator/tools/linear/matrices.hpp"
#include "generator/tools/linear/modes.hpp"

namespace eagerx::gen {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr std::size_t kMostMessages = 200;  // of delay that are tried

/// y = C·x + D·u of the opened port.
struct OpenLoop {
  Eigen::MatrixXd a, b, c, d;
  double message_s = 0.0;  // from one message to the next

  explicit OpenLoop(const SampledSystem& system)
      : a(matrix_of(system.a, system.state.size())),
        b(matrix_of(system.b, system.inputs.size()).rightCols(static_cast<Index>(system.opened))),
        c(matrix_of(system.c, system.state.size()).bottomRows(static_cast<Index>(system.opened))),
        d(matrix_of(system.d, system.inputs.size())
              .bottomRightCorner(static_cast<Index>(system.opened),
                                 static_cast<Index>(system.opened))),
        message_s(system.period_s / static_cast<double>(system.opened)) {}

  /// The map of a hyperperiod with u[k] = y[k - delay]: of the state and the messages on their way.
  [[nodiscard]] Eigen::MatrixXd closed(std::size_t delay) const {
    // Message i of a hyperperiod is u[i]; y[i] goes to u[i + delay], of this one or of a later.
    const Index n = a.rows(), m = c.rows(), q = static_cast<Index>(delay);
    // z = [x, the last `delay` messages of y, oldest first]; u = S·z + R·y.
    Eigen::MatrixXd s = Eigen::MatrixXd::Zero(m, n + q), r = Eigen::MatrixXd::Zero(m, m);
    for (Index i = 0; i < m; ++i) {
      if (i < q)
        s(i, n + i) = 1.0;
      else
        r(i, i - q) = 1.0;
    }
    Eigen::MatrixXd cz = Eigen::MatrixXd::Zero(m, n + q), az = Eigen::MatrixXd::Zero(n, n + q);
    cz.leftCols(n) = c;
    az.leftCols(n) = a;
    const Eigen::MatrixXd y =
        (Eigen::MatrixXd::Identity(m, m) - d * r).partialPivLu().solve(cz + d * s);
    Eigen::MatrixXd next(n + q, n + q);
    next.topRows(n) = az + b * (s + r * y);
    for (Index k = 0; k < q; ++k) {
      const Index at = k + m;  // of the old messages and then those of y
      if (at < q)
        next.row(n + k) = Eigen::RowVectorXd::Unit(n + q, n + at);
      else
        next.row(n + k) = y.row(at - q);
    }
    return next;
  }
};

/// G·u at frequencies, by the Schur form of A: a triangle to solve for each.
class FrequencyResponse {
 public:
  explicit FrequencyResponse(const OpenLoop& loop)
      : loop_(loop), schur_(loop.a.cast<Complex>().eval()) {
    b_ = schur_.matrixU().adjoint() * loop.b;
    c_ = loop.c * schur_.matrixU();
  }
  /// L, and what comes back at other frequencies, of it.
  Complex at(double w, double* others = nullptr) const {
    const Index m = loop_.c.rows(), n = loop_.a.rows();
    const double h = loop_.message_s;
    Eigen::VectorXcd u(m);
    for (Index i = 0; i < m; ++i) u[i] = std::polar(1.0, w * h * static_cast<double>(i));
    Eigen::VectorXcd y = loop_.d * u;
    if (n > 0) {
      const Complex z = std::polar(1.0, w * h * static_cast<double>(m));
      Eigen::MatrixXcd triangle = -schur_.matrixT();
      triangle.diagonal().array() += z;
      y += c_ * triangle.triangularView<Eigen::Upper>().solve(b_ * u);
    }
    const Complex back = u.dot(y) / static_cast<double>(m);
    if (others != nullptr)
      *others = (y - back * u).norm() / std::sqrt(static_cast<double>(m)) / std::abs(back);
    return -back;
  }
  /// Then L is not a number at 0 Hz, or a large one by rounding.
  [[nodiscard]] bool has_integrators() const {
    const Eigen::VectorXcd poles = schur_.matrixT().diagonal();
    return std::any_of(poles.begin(), poles.end(), is_integrator);
  }

 private:
  const OpenLoop& loop_;
  Eigen::ComplexSchur<Eigen::MatrixXcd> schur_;
  Eigen::MatrixXcd b_, c_;
};

/// Up to half of the rate of the messages.
std::vector<double> frequencies(const OpenLoop& loop, std::size_t count) {
  constexpr double kDecades = 5.0;
  std::vector<double> all;
  const double last = std::numbers::pi / loop.message_s;
  for (std::size_t i = 0; i < count; ++i) {
    const double part = static_cast<double>(count - 1 - i) / static_cast<double>(count - 1);
    all.push_back(last * std::pow(10.0, -kDecades * part));
  }
  return all;
}

/// Where f changes its sign between low and high.
template <class F>
double root(double low, double high, const F& f) {
  const bool sign = f(low) > 0.0;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    ((f(middle) > 0.0) == sign ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

class MarginFinder {
 public:
  explicit MarginFinder(const OpenLoop& loop) : loop_(loop), response_(loop) {}

  Margins find() {
    margins_.port_period_s = loop_.message_s;
    const Eigen::VectorXcd poles = poles_of(loop_.closed(0));
    margins_.spectral_radius = spectral_radius(poles);
    margins_.integrators = count_integrators(poles);
    margins_.is_stable = margins_.spectral_radius < 1.0;
    constexpr std::size_t kFrequencies = 4000;
    std::vector<double> all = frequencies(loop_, kFrequencies);
    Complex before = response_.at(all.front());
    peak(all.front(), before);
    for (std::size_t i = 1; i < all.size(); ++i) {
      const Complex now = response_.at(all[i]);
      if ((std::abs(before) > 1.0) != (std::abs(now) > 1.0)) cross_gain(all[i - 1], all[i]);
      if ((before.imag() > 0.0) != (now.imag() > 0.0) && before.real() + now.real() < 0.0)
        cross_phase(all[i - 1], all[i]);
      peak(all[i], now);
      before = now;
    }
    // At both ends L is real, and its imaginary part changes sign by rounding at most.
    take_factor(all.back(), before);
    if (!response_.has_integrators()) take_factor(0.0, response_.at(0.0));
    refine_peak(all[1] / all[0]);
    if (margins_.is_stable) {
      count_messages();
      choose_delay();
    }
    return margins_;
  }

 private:
  void cross_gain(double low, double high) {
    const double w = root(low, high, [&](double at) { return std::abs(response_.at(at)) - 1.0; });
    double others = 0.0;
    // From -180° on, against the clock: what a delay can take away.
    double phase = std::arg(-response_.at(w, &others));
    const double signed_deg = phase * 360.0 / kTurn;
    if (!margins_.phase_deg || std::abs(signed_deg) < std::abs(*margins_.phase_deg)) {
      margins_.phase_deg = signed_deg;
      margins_.crossover_hz = w / kTurn;
      margins_.other_frequencies = others;
    }
    if (phase < 0.0) phase += kTurn;
    delays_.push_back({phase / w, w / kTurn});
  }
  void cross_phase(double low, double high) {
    const double w = root(low, high, [&](double at) { return response_.at(at).imag(); });
    take_factor(w, response_.at(w));
  }
  /// L is real at this frequency: where it is negative, a factor makes it -1.
  void take_factor(double w, Complex loop) {
    constexpr double kLeast = 1e-9, kMost = 1e9;  // beyond, it is rounding
    if (!(loop.real() < -kLeast && loop.real() > -kMost)) return;
    const double factor = 1.0 / std::abs(loop);
    if (factor > 1.0 && (!margins_.gain || factor < *margins_.gain)) {
      margins_.gain = factor;
      margins_.gain_frequency_hz = w / kTurn;
    }
    if (factor < 1.0 && (!margins_.least_gain || factor > *margins_.least_gain)) {
      margins_.least_gain = factor;
      margins_.least_gain_frequency_hz = w / kTurn;
    }
  }
  void peak(double w, Complex loop) {
    const double sensitivity = 1.0 / std::abs(1.0 + loop);
    if (sensitivity <= margins_.sensitivity) return;
    margins_.sensitivity = sensitivity;
    margins_.sensitivity_hz = w / kTurn;
  }
  /// Between the neighbors of the largest one: golden section.
  void refine_peak(double ratio) {
    constexpr double kGolden = 0.6180339887498949;
    const double middle = margins_.sensitivity_hz * kTurn;
    double low = middle / ratio,
           high = std::min(middle * ratio, std::numbers::pi / loop_.message_s);
    for (int i = 0; i < 60; ++i) {
      const double one = high - kGolden * (high - low), other = low + kGolden * (high - low);
      const Complex at_one = response_.at(one), at_other = response_.at(other);
      peak(one, at_one);
      peak(other, at_other);
      (std::abs(1.0 + at_one) < std::abs(1.0 + at_other) ? high : low) =
          std::abs(1.0 + at_one) < std::abs(1.0 + at_other) ? other : one;
    }
  }
  /// The shortest delay that reaches the limit; what is shorter than what the loop bears has other
  /// frequencies to thank for its gain of 1.
  void choose_delay() {
    constexpr double kRounding = 1.0 - 1e-9;
    const double borne_s =
        kRounding * loop_.message_s * static_cast<double>(margins_.stable_messages.value_or(0));
    for (const Delay& each : delays_) {
      if (each.s < borne_s || (margins_.delay_s && each.s >= *margins_.delay_s)) continue;
      margins_.delay_s = each.s;
      margins_.delay_frequency_hz = each.frequency_hz;
    }
  }
  void count_messages() {
    for (std::size_t delay = 1; delay <= kMostMessages; ++delay) {
      if (spectral_radius(poles_of(loop_.closed(delay))) < 1.0) continue;
      margins_.stable_messages = delay - 1;
      return;
    }
  }

  struct Delay {
    double s, frequency_hz;
  };

  const OpenLoop& loop_;
  FrequencyResponse response_;
  Margins margins_;
  std::vector<Delay> delays_;  // that reach the limit, by crossover
};

}  // namespace

Margins margins_of(const SampledSystem& system) {
  const OpenLoop loop(system);
  return MarginFinder(loop).find();
}

std::vector<Response> responses_of(const SampledSystem& system, std::size_t count) {
  const OpenLoop loop(system);
  const FrequencyResponse response(loop);
  std::vector<Response> result;
  for (const double w : frequencies(loop, count)) result.push_back({w / kTurn, response.at(w)});
  return result;
}

}  // namespace eagerx::gen
