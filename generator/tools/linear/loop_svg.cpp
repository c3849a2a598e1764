#include "generator/tools/linear/loop_svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "generator/tools/trace/axis.hpp"
#include "generator/tools/trace/svg.hpp"

namespace eagerx::gen {
namespace {

constexpr int kPageWidth = 760, kPageTitle = 36;
constexpr double kMostGain_dB = 80.0;  // of what is shown, up and down
constexpr const char* kSimulatedLook = " stroke-dasharray=\"4 4\"";
constexpr std::size_t kLoopColour = 0, kMarginColour = 1, kOtherColour = 2;  // colours
/// Words over lines stay readable; guides and lines between decades stay behind.
constexpr const char* kStyle =
    "<style>.over{paint-order:stroke;stroke:#fff;stroke-width:4px;stroke-linejoin:round}"
    ".minor{stroke:#f2f4f7}.guide{fill:none;stroke:#98a2b3;stroke-dasharray:2 3}"
    ".small{font-size:9px}@media(prefers-color-scheme:dark){.over{stroke:#101828}"
    ".minor{stroke:#1d2939}.guide{stroke:#667085}}</style>\n";

/// A rectangle of the picture with axes of its own, in pixels.
class Axes {
 public:
  struct Frame {
    double left, right, top, bottom;
  };
  enum class Scale : unsigned char { linear, logarithmic };
  Axes(Frame frame, PlotRange x, PlotRange y, Scale of_x = Scale::linear)
      : frame_(frame), x_(x), y_(y), is_logarithmic_(of_x == Scale::logarithmic) {}

  double x(double value) const {
    return frame_.left + (frame_.right - frame_.left) * x_.share(value);
  }
  double y(double value) const {
    return frame_.bottom - (frame_.bottom - frame_.top) * y_.share(value);
  }

  std::string grid(const std::vector<PlotMark>& columns, const std::vector<PlotMark>& rows,
                   const std::string& title, const std::string& under) const {
    std::string text = svg_label(frame_.left, frame_.top - 8, "start", title, "name");
    for (const PlotMark& mark : columns) text += between(mark.value);
    for (const PlotMark& mark : rows) {
      text += fmt::format("<path class=\"grid\" d=\"M{:.1f} {:.1f}H{:.1f}\"/>\n", frame_.left,
                          y(mark.value), frame_.right);
      text += svg_label(frame_.left - 6, y(mark.value) + 4, "end", mark.text, "");
    }
    for (const PlotMark& mark : columns) {
      text += fmt::format("<path class=\"grid\" d=\"M{:.1f} {:.1f}V{:.1f}\"/>\n", x(mark.value),
                          frame_.top, frame_.bottom);
      text += svg_label(x(mark.value), frame_.bottom + 16, "middle", mark.text, "");
    }
    return text + svg_label(frame_.right, frame_.bottom + 32, "end", under, "");
  }
  /// At the vertical axis, upward.
  std::string left_words(const std::string& words) const {
    const double x = frame_.left - 40, y = 0.5 * (frame_.top + frame_.bottom);
    return fmt::format(
        "<text transform=\"translate({:.1f} {:.1f}) rotate(-90)\" "
        "text-anchor=\"middle\">{}</text>\n",
        x, y, words);
  }
  /// Below the plot on the left, at a distance in pixels.
  std::string below(double right, const std::string& words, const std::string& look) const {
    return svg_label(frame_.left + right, frame_.bottom + 32, "start", words, look);
  }
  /// Lines between points, in as many pieces as leave and enter the rectangle.
  std::string curve(const std::vector<std::pair<double, double>>& points, std::size_t colour,
                    const std::string& look = {}) const {
    std::string text, piece;
    const auto end = [&] {
      if (!piece.empty())
        text += fmt::format("<path class=\"line l{}\"{} d=\"M{}\"/>\n", colour, look, piece);
      piece.clear();
    };
    for (const auto& [at, value] : points) {
      const bool inside = x_.low <= at && at <= x_.high && y_.low <= value && value <= y_.high;
      if (!inside) {
        end();
        continue;
      }
      piece += fmt::format("{}{:.1f} {:.1f}", piece.empty() ? "" : "L", x(at), y(value));
    }
    end();
    return text;
  }
  std::string dot(double at, double value, std::size_t colour) const {
    if (at < x_.low || at > x_.high || value < y_.low || value > y_.high) return {};
    return fmt::format("<circle class=\"t{}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3.5\"/>\n", colour,
                       x(at), y(value));
  }
  std::string cross(double at, double value, std::size_t colour) const {
    if (at < x_.low || at > x_.high || value < y_.low || value > y_.high) return {};
    return fmt::format("<path class=\"line l{}\" d=\"M{:.1f} {:.1f}l8 8m0 -8l-8 8\"/>\n", colour,
                       x(at) - 4, y(value) - 4);
  }
  /// From one value to another at `at`: a margin, with its text.
  std::string upright(double at, double from, double to, const std::string& said) const {
    const double middle = 0.5 * (y(from) + y(to));
    const bool is_right = x_.share(at) > 0.7;
    return fmt::format("<path class=\"line l{}\" d=\"M{:.1f} {:.1f}V{:.1f}\"/>\n", kMarginColour,
                       x(at), y(from), y(to)) +
           svg_label(x(at) + (is_right ? -6 : 6), middle + 4, is_right ? "end" : "start", said,
                     fmt::format("t{} over", kMarginColour));
  }
  /// A vertical line through the plot, which joins the same frequency in two plots.
  std::string guide(double at) const {
    if (at < x_.low || at > x_.high) return {};
    return fmt::format("<path class=\"guide\" d=\"M{:.1f} {:.1f}V{:.1f}\"/>\n", x(at), frame_.top,
                       frame_.bottom);
  }
  /// The head of an arrow at the second point, in the direction from the first one.
  std::string arrow(std::pair<double, double> from, std::pair<double, double> to,
                    std::size_t colour) const {
    const double across = x(to.first) - x(from.first), down = y(to.second) - y(from.second);
    const double degrees = std::atan2(down, across) * 180.0 / std::numbers::pi;
    return fmt::format(
        "<path class=\"t{}\" transform=\"translate({:.1f} {:.1f}) rotate({:.1f})\" "
        "d=\"M4 0l-8 -4v8z\"/>\n",
        colour, x(to.first), y(to.second), degrees);
  }
  std::string level(double value) const {
    return fmt::format(
        "<path class=\"line l{}\" stroke-dasharray=\"4 4\" d=\"M{:.1f} {:.1f}H{:.1f}\"/>\n",
        kMarginColour, frame_.left, y(value), frame_.right);
  }

  /// Where the axis shows powers of ten: 2 to 9 times this power, and below the first one.
  std::string between(double power) const {
    std::string text;
    if (!is_logarithmic_ || x_.high - x_.low > kMostDecades) return text;
    for (int i = 2; i < 10; ++i) {
      for (const double from : {power - 1.0, power}) {
        const double at = from + std::log10(static_cast<double>(i));
        const bool is_first = from < power && power - 1.0 < x_.low;
        if (at < x_.low || at > x_.high || (from < power && !is_first)) continue;
        text += fmt::format("<path class=\"minor\" d=\"M{:.1f} {:.1f}V{:.1f}\"/>\n", x(at),
                            frame_.top, frame_.bottom);
      }
    }
    return text;
  }

 private:
  static constexpr double kMostDecades = 7.0;  // with lines in between
  Frame frame_;
  PlotRange x_, y_;
  bool is_logarithmic_ = false;
};

/// Powers of ten, as values of log10.
std::vector<PlotMark> decades(const PlotRange& range) {
  std::vector<PlotMark> marks;
  for (double power = std::ceil(range.low); power <= range.high; ++power)
    marks.push_back({power, fmt::format("{:g}", std::pow(10.0, power))});
  return marks;
}

class LoopPicture {
 public:
  explicit LoopPicture(const LoopCurves& curves)
      : curves_(curves),
        margins_(curves.margins),
        frequencies_{std::log10(curves.bode.front().frequency_hz),
                     std::log10(curves.bode.back().frequency_hz)} {}

  std::string draw(const std::string& title) const {
    constexpr int kHeight = 1072;
    return svg_begin(kPageWidth, kHeight) + kStyle + svg_label(70, 18, "start", title, "name") +
           svg_label(70, 34, "start", summary(), "") + gain() + phase() + nyquist() + poles() +
           step() + "</svg>\n";
  }

 private:
  using Points = std::vector<std::pair<double, double>>;

  std::string summary() const {
    std::string text = margins_.is_stable ? "closed loop stable" : "closed loop unstable";
    if (margins_.gain) text += fmt::format(", gain margin {:.3g} dB", decibels(*margins_.gain));
    if (margins_.least_gain)
      text += fmt::format(", least gain {:.3g} dB", decibels(*margins_.least_gain));
    if (margins_.phase_deg) text += fmt::format(", phase margin {:.3g} deg", *margins_.phase_deg);
    if (margins_.delay_s)
      text += fmt::format(", delay margin {:.3g} ms", 1000.0 * *margins_.delay_s);
    return text;
  }
  static double decibels(double factor) { return 20.0 * std::log10(factor); }

  /// The frequencies of the margins, the same in both Bode plots.
  std::string guides(const Axes& axes) const {
    std::string text;
    for (const auto& at_hz :
         {margins_.crossover_hz, margins_.gain_frequency_hz, margins_.least_gain_frequency_hz}) {
      if (at_hz && *at_hz > 0.0) text += axes.guide(std::log10(*at_hz));
    }
    return text;
  }

  /// A column of the Bode plot over the logarithm of the frequency, and its range with -180 or 0.
  Points over_frequency(double BodePoint::*column, PlotRange& range) const {
    Points points;
    for (const BodePoint& each : curves_.bode) {
      points.emplace_back(std::log10(each.frequency_hz), each.*column);
      range.low = std::min(range.low, each.*column);
      range.high = std::max(range.high, each.*column);
    }
    return points;
  }

  std::string gain() const {
    PlotRange range{0.0, 0.0};
    const Points points = over_frequency(&BodePoint::gain_db, range);
    range = {std::max(range.low, -kMostGain_dB) - 5.0, std::min(range.high, kMostGain_dB) + 5.0};
    const Axes axes({70, 690, kPageTitle + 24, 240}, frequencies_, range, Axes::Scale::logarithmic);
    std::string text =
        axes.grid(decades(frequencies_), marks_of(range, 5),
                  fmt::format("gain of the loop opened at {} [dB]", curves_.port), "");
    text += guides(axes) + axes.level(0.0) + axes.curve(points, kLoopColour);
    if (margins_.crossover_hz)
      text += axes.dot(std::log10(*margins_.crossover_hz), 0.0, kMarginColour);
    const auto margin = [&](const std::optional<double>& factor,
                            const std::optional<double>& at_hz) {
      if (!factor || *at_hz < curves_.bode.front().frequency_hz) return;
      const double level = -decibels(*factor);
      if (level < range.low || level > range.high) return;
      text += axes.dot(std::log10(*at_hz), level, kMarginColour);
      text += axes.upright(std::log10(*at_hz), 0.0, level, fmt::format("{:.3g} dB", -level));
    };
    margin(margins_.gain, margins_.gain_frequency_hz);
    margin(margins_.least_gain, margins_.least_gain_frequency_hz);
    return text;
  }

  std::string phase() const {
    PlotRange range{-180.0, -180.0};
    const Points points = over_frequency(&BodePoint::phase_deg, range);
    range = {std::max(range.low, -1080.0) - 10.0, std::min(range.high, 1080.0) + 10.0};
    const Axes axes({70, 690, 290, 450}, frequencies_, range, Axes::Scale::logarithmic);
    std::vector<PlotMark> rows;
    const double step = range.high - range.low > 720.0 ? 180.0 : 90.0;
    for (double at = std::ceil(range.low / step) * step; at <= range.high; at += step)
      rows.push_back({at, fmt::format("{:g}", at + 0.0)});
    std::string text = axes.grid(decades(frequencies_), rows, "phase [deg]", "frequency [Hz]");
    text += guides(axes);
    for (double at = -900.0; at <= 900.0; at += 360.0) {
      if (range.low < at && at < range.high) text += axes.level(at);
    }
    return text + axes.curve(points, kLoopColour) + phase_margin(axes, range);
  }
  std::string phase_margin(const Axes& axes, const PlotRange& range) const {
    if (!margins_.phase_deg || -180.0 < range.low) return {};
    const double at = std::log10(*margins_.crossover_hz), phase = *margins_.phase_deg - 180.0;
    return axes.dot(at, phase, kMarginColour) +
           axes.upright(at, -180.0, phase, fmt::format("{:.3g} deg", *margins_.phase_deg));
  }

  std::string nyquist() const {
    const PlotRange range{-3.0, 3.0};
    const Axes axes({70, 350, 520, 800}, range, range);
    std::string text =
        axes.grid(marks_of(range, 6), marks_of(range, 6), "Nyquist plot of L", "real part");
    Points points, mirrored;
    for (const BodePoint& each : curves_.bode) {
      points.emplace_back(each.loop.real(), each.loop.imag());
      mirrored.emplace_back(each.loop.real(), -each.loop.imag());
    }
    // The curve stays outside: the peak of the sensitivity is the nearest that it comes.
    text += circle(axes, -1.0, 1.0 / margins_.sensitivity, range) + unit_circle(axes);
    text += axes.curve(points, kLoopColour) +
            axes.curve(mirrored, kLoopColour, " stroke-opacity=\"0.4\"") + direction(axes, points);
    return text + axes.cross(-1.0, 0.0, kMarginColour) +
           svg_label(axes.x(-1.0) - 8, axes.y(0.0) - 6, "end", "-1",
                     fmt::format("t{} over", kMarginColour)) +
           axes.left_words("imaginary part") + axes.below(0.0, "dotted: |L| = 1", "small") +
           axes.below(90.0, fmt::format("dashed: peak of |S|, {:.3g}", margins_.sensitivity),
                      fmt::format("t{} small", kMarginColour));
  }
  static std::string unit_circle(const Axes& axes) {
    return fmt::format("<circle class=\"guide\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\"/>\n",
                       axes.x(0.0), axes.y(0.0), axes.x(1.0) - axes.x(0.0));
  }
  /// An arrow to higher frequencies where the curve is last 1.5 from the origin, or at its middle.
  std::string direction(const Axes& axes, const Points& points) const {
    constexpr double kFar = 1.5, kInside = 2.8;
    std::size_t at = points.size() / 2;
    for (std::size_t i = 1; i < points.size(); ++i) {
      const double size = std::abs(curves_.bode[i].loop);
      if (size > kFar && size < kInside) at = i;
    }
    if (at == 0 || at >= points.size() || std::abs(curves_.bode[at].loop) > kInside) return {};
    return axes.arrow(points[at - 1], points[at], kLoopColour);
  }
  /// Around a point of the real axis.
  static std::string circle(const Axes& axes, double center, double radius,
                            const PlotRange& range) {
    if (center - radius < range.low || center + radius > range.high) return {};
    return fmt::format(
        "<circle class=\"line l{}\" stroke-dasharray=\"4 4\" cx=\"{:.1f}\" cy=\"{:.1f}\" "
        "r=\"{:.1f}\"/>\n",
        kMarginColour, axes.x(center), axes.y(0.0), axes.x(center + radius) - axes.x(center));
  }

  std::string poles() const {
    double most = 1.1;
    for (const std::complex<double> z : curves_.closed_poles)
      most = std::max(most, std::min(std::abs(z) + 0.1, 3.0));
    const PlotRange range{-most, most};
    const Axes axes({430, 710, 520, 800}, range, range);
    std::string text = axes.grid(marks_of(range, 6), marks_of(range, 6),
                                 "poles z: open loop (dots), closed loop (x)", "real part");
    for (const double damping : {0.2, 0.4, 0.6, 0.8}) text += damped(axes, damping);
    text += circle(axes, 0.0, 1.0, range) + axes.left_words("imaginary part") +
            axes.below(0.0, "dotted: damping 0.2, 0.4, 0.6, 0.8", "small");
    for (const std::complex<double> z : curves_.open_poles)
      text += axes.dot(z.real(), z.imag(), kOtherColour);
    for (const std::complex<double> z : curves_.closed_poles)
      text += axes.cross(z.real(), z.imag(), kLoopColour);
    return text;
  }

  /// z = exp(s·T) of all s with this damping, up to half a turn.
  static std::string damped(const Axes& axes, double damping) {
    constexpr int kParts = 48;
    const double decay = damping / std::sqrt(1.0 - damping * damping);
    std::string text = "<path class=\"guide\" d=\"";
    for (int i = -kParts; i <= kParts; ++i) {
      const double angle = std::numbers::pi * i / kParts;
      const std::complex<double> z = std::polar(std::exp(-decay * std::abs(angle)), angle);
      text += fmt::format("{}{:.1f} {:.1f}", i == -kParts ? "M" : "L", axes.x(z.real()),
                          axes.y(z.imag()));
    }
    return text + "\"/>\n";
  }

  std::string step() const {
    Points returned, sent;
    PlotRange range{0.0, 1.0};
    for (const StepSample& each : curves_.step) {
      returned.emplace_back(each.time_s, each.returned);
      sent.emplace_back(each.time_s, each.sent);
      range.low = std::min({range.low, each.returned, each.sent});
      range.high = std::max({range.high, each.returned, each.sent});
    }
    Points simulated, simulated_sent;
    const double height = range.high - range.low;  // that of the linear model may double
    const PlotRange most{range.low - height, range.high + height};
    for (const StepSample& each : curves_.simulated.step) {
      simulated.emplace_back(each.time_s, each.returned);
      simulated_sent.emplace_back(each.time_s, each.sent);
      range.low = std::max(most.low, std::min({range.low, each.returned, each.sent}));
      range.high = std::min(most.high, std::max({range.high, each.returned, each.sent}));
    }
    const PlotRange time{0.0, curves_.step.back().time_s};
    const Axes axes({70, 690, 870, 1010}, time, range);
    return axes.grid(marks_of(time, 8), marks_of(range, 4),
                     "closed loop after a unit step at the port", "time [s]") +
           axes.below(0.0, "T: what returns", fmt::format("t{}", kLoopColour)) +
           axes.below(110.0, "S = 1 - T: what its readers get", fmt::format("t{}", kOtherColour)) +
           axes.curve(returned, kLoopColour) + axes.curve(sent, kOtherColour) +
           axes.curve(simulated, kMarginColour, kSimulatedLook) +
           axes.curve(simulated_sent, kMarginColour, kSimulatedLook) + simulated_text();
  }

  std::string simulated_text() const {
    const SimulatedStep& simulated = curves_.simulated;
    if (simulated.size == 0.0) return {};
    return svg_label(70, 1058, "start",
                     fmt::format("dashed: simulated, a step of {:.3g}{}{}, divided by its size",
                                 simulated.size, simulated.unit.empty() ? "" : " ", simulated.unit),
                     fmt::format("t{}", kMarginColour));
  }

  const LoopCurves& curves_;
  const Margins& margins_;
  PlotRange frequencies_;  // as logarithms
};

}  // namespace

std::string loop_svg(const LoopCurves& curves, const std::string& title) {
  return LoopPicture(curves).draw(title);
}

}  // namespace eagerx::gen
