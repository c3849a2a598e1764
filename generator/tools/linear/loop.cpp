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

#include "generator/tools/linear/modes.hpp"
#include "generator/tools/linear/open_loop.hpp"

namespace eagerx::gen {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr std::size_t kMostMessages = 200;  // of delay that are tried
constexpr double kMostCost = 1e9;  // of their eigenvalues: the sum of n^3, some ten seconds

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
    const Eigen::VectorXcd all = poles();
    return std::any_of(all.begin(), all.end(), is_integrator);
  }
  [[nodiscard]] Eigen::VectorXcd poles() const { return schur_.matrixT().diagonal(); }

 private:
  const OpenLoop& loop_;
  Eigen::ComplexSchur<Eigen::MatrixXcd> schur_;
  Eigen::MatrixXcd b_, c_;
};

/// Half of the rate of the messages. With an even number of them in a hyperperiod, integrators are
/// an alias of it: L is large there within rounding, and a little below it is not.
double last_frequency(const OpenLoop& loop) {
  const double last = std::numbers::pi / loop.message_s;
  return loop.c.rows() % 2 == 0 ? (1.0 - 1e-6) * last : last;
}

std::vector<double> frequencies(const OpenLoop& loop, std::size_t count) {
  constexpr double kDecades = 5.0;
  std::vector<double> all;
  const double last = last_frequency(loop);
  for (std::size_t i = 0; i < count; ++i) {
    const double part = static_cast<double>(count - 1 - i) / static_cast<double>(count - 1);
    all.push_back(last * std::pow(10.0, -kDecades * part));
  }
  return all;
}

/// Adds what a grid misses: the resonances of poles with little damping, and their flanks. Of a
/// hyperperiod of several messages a pole has several frequencies up to half of their rate.
void add_resonances(const Eigen::VectorXcd& poles, const OpenLoop& loop, std::vector<double>& all) {
  constexpr double kBroad = 0.02;  // damping of which the grid has many points
  const double last = last_frequency(loop), first = all.front();
  const Index messages = loop.c.rows();
  const double period_s = loop.message_s * static_cast<double>(messages);
  for (const Complex z : poles) {
    const double size = std::abs(z);
    if (z.imag() <= 0.0 || size < 1e-6 || is_integrator(z)) continue;
    const double decay = std::abs(std::log(size)) / period_s, turn = std::arg(z) / period_s;
    for (Index k = -messages; k <= messages; ++k) {
      const double w = std::abs(turn + kTurn * static_cast<double>(k) / period_s);
      if (w < first || w >= last || decay > kBroad * w) continue;
      for (const double width : {-10.0, -3.0, -1.0, -0.3, 0.0, 0.3, 1.0, 3.0, 10.0}) {
        const double at = w + width * std::max(decay, 1e-9 * w);
        if (at > first && at < last) all.push_back(at);
      }
    }
  }
  std::ranges::sort(all);
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
    const double ratio = all[1] / all[0];
    add_resonances(response_.poles(), loop_, all);
    add_resonances(poles, loop_, all);
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
    refine_peak(ratio);
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
    if (!(sensitivity > margins_.sensitivity)) return;  // also at a pole, where it is no number
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
  /// With one message a hyperperiod the response says where the limit is, which eigenvalues then
  /// confirm. Otherwise it says too little, and they are computed for one delay after the other.
  void count_messages() {
    std::size_t delay = 1;
    if (loop_.c.rows() == 1) {
      const std::size_t borne = messages_by_response();
      if (borne > 0 && is_stable_with(borne)) delay = borne + 1;
      margins_.tried_messages = delay - 1;
    }
    double cost = 0.0;
    for (; delay <= kMostMessages && cost < kMostCost; ++delay) {
      cost += std::pow(static_cast<double>(loop_.a.rows()) + static_cast<double>(delay), 3.0);
      if (is_stable_with(delay)) {
        margins_.tried_messages = delay;
        continue;
      }
      margins_.stable_messages = delay - 1;
      return;
    }
  }
  bool is_stable_with(std::size_t delay) const {
    return spectral_radius(poles_of(loop_.closed(delay))) < 1.0;
  }
  /// Messages in the shortest delay at which a crossover reaches the limit, at most kMostMessages.
  std::size_t messages_by_response() const {
    double shortest_s = loop_.message_s * static_cast<double>(kMostMessages + 1);
    for (const Delay& each : delays_) shortest_s = std::min(shortest_s, each.s);
    const double messages = std::ceil(shortest_s / loop_.message_s * (1.0 - 1e-9)) - 1.0;
    return static_cast<std::size_t>(std::max(0.0, messages));
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

std::vector<std::complex<double>> closed_poles_of(const SampledSystem& system) {
  const Eigen::VectorXcd poles = poles_of(OpenLoop(system).closed(0));
  return {poles.begin(), poles.end()};
}

std::vector<Response> responses_of(const SampledSystem& system, std::size_t count) {
  const OpenLoop loop(system);
  const FrequencyResponse response(loop);
  std::vector<Response> result;
  for (const double w : frequencies(loop, count)) result.push_back({w / kTurn, response.at(w)});
  return result;
}

}  // namespace eagerx::gen
