#include "generator/tools/linear/loop_svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "generator/tools/trace/axis.hpp"
#include "generator/tools/trace/svg.hpp"

namespace eagerx::gen {
namespace {

constexpr int kPageWidth = 760, kPageTitle = 36;
constexpr double kMostGain_dB = 80.0;  // of what is shown, up and down
constexpr const char* kSimulatedLook = " stroke-dasharray=\"4 4\"";
constexpr std::size_t kLoopColour = 0, kMarginColour = 1, kOtherColour = 2;  // colours

/// A rectangle of the picture with axes of its own, in pixels.
class Axes {
 public:
  struct Frame {
    double left, right, top, bottom;
  };
  Axes(Frame frame, PlotRange x, PlotRange y) : frame_(frame), x_(x), y_(y) {}

  double x(double value) const {
    return frame_.left + (frame_.right - frame_.left) * x_.share(value);
  }
  double y(double value) const {
    return frame_.bottom - (frame_.bottom - frame_.top) * y_.share(value);
  }

  std::string grid(const std::vector<PlotMark>& columns, const std::vector<PlotMark>& rows,
                   const std::string& title, const std::string& under) const {
    std::string text = svg_label(frame_.left, frame_.top - 8, "start", title, "name");
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
                     fmt::format("t{}", kMarginColour));
  }
  std::string level(double value) const {
    return fmt::format(
        "<path class=\"line l{}\" stroke-dasharray=\"4 4\" d=\"M{:.1f} {:.1f}H{:.1f}\"/>\n",
        kMarginColour, frame_.left, y(value), frame_.right);
  }

 private:
  Frame frame_;
  PlotRange x_, y_;
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
    constexpr int kHeight = 1060;
    return svg_begin(kPageWidth, kHeight) + svg_label(70, 22, "start", title, "name") + gain() +
           phase() + nyquist() + poles() + step() + "</svg>\n";
  }

 private:
  using Points = std::vector<std::pair<double, double>>;

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
    const Axes axes({70, 690, kPageTitle + 24, 240}, frequencies_, range);
    std::string text =
        axes.grid(decades(frequencies_), marks_of(range, 5),
                  fmt::format("gain of the loop opened at {} [dB]", curves_.port), "");
    text += axes.level(0.0) + axes.curve(points, kLoopColour);
    const auto margin = [&](const std::optional<double>& factor,
                            const std::optional<double>& at_hz) {
      if (!factor || *at_hz < curves_.bode.front().frequency_hz) return;
      const double level = -20.0 * std::log10(*factor);
      if (level < range.low || level > range.high) return;
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
    const Axes axes({70, 690, 290, 450}, frequencies_, range);
    std::vector<PlotMark> rows;
    const double step = range.high - range.low > 720.0 ? 180.0 : 90.0;
    for (double at = std::ceil(range.low / step) * step; at <= range.high; at += step)
      rows.push_back({at, fmt::format("{:g}", at + 0.0)});
    std::string text = axes.grid(decades(frequencies_), rows, "phase [deg]", "frequency [Hz]");
    for (double at = -900.0; at <= 900.0; at += 360.0) {
      if (range.low < at && at < range.high) text += axes.level(at);
    }
    return text + axes.curve(points, kLoopColour) + phase_margin(axes, points, range);
  }
  std::string phase_margin(const Axes& axes, const Points& points, const PlotRange& range) const {
    if (!margins_.phase_deg) return {};
    const double at = std::log10(*margins_.crossover_hz);
    const auto near =
        std::ranges::lower_bound(points, at, {}, [](const auto& one) { return one.first; });
    if (near == points.end()) return {};
    const double limit = 360.0 * std::round((near->second + 180.0) / 360.0) - 180.0;
    if (limit < range.low || limit > range.high) return {};
    return axes.upright(at, limit, limit + *margins_.phase_deg,
                        fmt::format("{:.3g} deg", *margins_.phase_deg));
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
    text += circle(axes, -1.0, 1.0 / margins_.sensitivity, range);
    text += axes.curve(points, kLoopColour) +
            axes.curve(mirrored, kLoopColour, " stroke-opacity=\"0.4\"");
    return text + axes.cross(-1.0, 0.0, kMarginColour) +
           svg_label(axes.x(-1.0) - 8, axes.y(0.0) - 6, "end", "-1",
                     fmt::format("t{}", kMarginColour));
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
    text += circle(axes, 0.0, 1.0, range);
    for (const std::complex<double> z : curves_.open_poles)
      text += axes.dot(z.real(), z.imag(), kOtherColour);
    for (const std::complex<double> z : curves_.closed_poles)
      text += axes.cross(z.real(), z.imag(), kLoopColour);
    return text;
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
                     "closed loop after a unit step at the port: T (what returns) and S = 1 - T",
                     "time [s]") +
           axes.curve(returned, kLoopColour) + axes.curve(sent, kOtherColour) +
           axes.curve(simulated, kMarginColour, kSimulatedLook) +
           axes.curve(simulated_sent, kMarginColour, kSimulatedLook) + simulated_text();
  }

  std::string simulated_text() const {
    const SimulatedStep& simulated = curves_.simulated;
    if (simulated.size == 0.0) return {};
    return svg_label(70, 1042, "start",
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
