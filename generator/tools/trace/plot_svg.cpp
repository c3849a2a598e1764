#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "generator/tools/trace/axis.hpp"
#include "generator/tools/trace/svg.hpp"

namespace eagerx::gen {
namespace {

constexpr int kWidth = 760, kLeft = 70, kRight = 690, kTitle = 36;
// A panel with its title and legend, and the time.
constexpr int kPanel = 150, kAbove = 24, kBottom = 40, kLegendRow = 16;
constexpr std::size_t kMostInLegend = 17;
// From the seventh element on, dashes tell lines of one colour apart.
constexpr std::array<const char*, 3> kDashes = {"", "6 3", "2 2"};

class Plot {
 public:
  explicit Plot(const std::vector<PlotPanel>& panels)
      : panels_(panels), time_(time_range(panels)) {}

  std::string draw(const std::string& title) {
    int height = kTitle + kBottom;
    for (const PlotPanel& each : panels_) height += kPanel + kLegendRow * rows_of_legend(each);
    std::string text = svg_begin(kWidth, height);
    text += svg_label(kLeft, 22, "start", title, "name");
    int top = kTitle;
    for (const PlotPanel& each : panels_) {
      const int rows = rows_of_legend(each);
      text += panel(each, top, top + kLegendRow * rows);
      top += kPanel + kLegendRow * rows;
    }
    const int bottom = height - kBottom;
    for (const PlotMark& mark : marks_of(time_, 8))
      text += svg_label(x(mark.value), bottom + 18, "middle", mark.text, "");
    return text + svg_label(kRight, bottom + 34, "end", "time in the episode [s]", "") + "</svg>\n";
  }

 private:
  double x(double time_s) const { return kLeft + (kRight - kLeft) * time_.share(time_s); }

  /// Of the plot, which begins at `top`, below the title at `title` and the legend.
  std::string panel(const PlotPanel& panel, int title, int top) const {
    const PlotRange range = value_range(panel);
    const double from = top + kAbove, to = top + kPanel - 6;
    const auto y = [&](double value) { return to - (to - from) * range.share(value); };
    std::string text = svg_label(kLeft, title + 16, "start", panel.title, "name");
    if (!panel.unit.empty()) text += unit_label(panel.unit, (from + to) / 2);
    for (const PlotMark& mark : marks_of(range, 4)) {
      text +=
          fmt::format("<path class=\"grid\" d=\"M{} {:.1f}H{}\"/>\n", kLeft, y(mark.value), kRight);
      text += svg_label(kLeft - 6, y(mark.value) + 4, "end", mark.text, "");
    }
    for (const PlotMark& mark : marks_of(time_, 8))
      text += fmt::format("<path class=\"grid\" d=\"M{:.1f} {:.1f}V{:.1f}\"/>\n", x(mark.value),
                          from, to);
    for (const PlotLine& line : panel.lines) text += curve(line, panel, y);
    return text + legend(panel, title + 16);
  }

  /// Upright, left of the numbers.
  static std::string unit_label(const std::string& unit, double y) {
    return fmt::format("<g transform=\"translate(14 {:.1f}) rotate(-90)\">{}</g>\n", y,
                       svg_label(0, 0, "middle", "[" + unit + "]", ""));
  }

  template <class Y>
  std::string curve(const PlotLine& line, const PlotPanel& panel, Y&& y) const {
    std::string points;
    for (const std::size_t i : thinned(line, time_, kRight - kLeft))
      points += fmt::format("{:.1f},{:.1f} ", x(line.time_s[i]), y(line.value[i]));
    if (points.empty()) return {};
    points.pop_back();
    const bool many = panel.lines.size() > panel.elements;
    return fmt::format("<polyline class=\"line l{}\"{}{} points=\"{}\"/>\n",
                       line.element % kSvgColours, dash_of(line.element),
                       many ? " stroke-opacity=\"0.6\"" : "", points);
  }

  static std::string dash_of(std::uint64_t element) {
    const char* const dash = kDashes[element / kSvgColours % kDashes.size()];
    return *dash == 0 ? "" : fmt::format(" stroke-dasharray=\"{}\"", dash);
  }

  /// Places of the entries of a legend, from the left, in rows below the title.
  struct Entry {
    double x;
    int row;
    std::string text;
  };
  static std::vector<Entry> entries_of(const PlotPanel& panel) {
    constexpr double kSample = 26, kCharacter = 6.7, kBetween = 12;
    std::vector<Entry> entries;
    const std::size_t shown = std::min(panel.names.size(), kMostInLegend);
    double at = kLeft;
    int row = 1;
    for (std::size_t i = 0; i < shown; ++i) {
      std::string text = panel.names[i];
      if (i + 1 == shown && panel.names.size() > shown)
        text += fmt::format(" and {} more", panel.names.size() - shown);
      const double width = kSample + kCharacter * static_cast<double>(text.size());
      if (at > kLeft && at + width > kRight) {
        at = kLeft;
        ++row;
      }
      entries.push_back({at, row, std::move(text)});
      at += width + kBetween;
    }
    return entries;
  }
  static int rows_of_legend(const PlotPanel& panel) {
    const std::vector<Entry> entries = entries_of(panel);
    return entries.empty() ? 0 : entries.back().row;
  }

  /// Which element has which colour and dashes.
  static std::string legend(const PlotPanel& panel, double title) {
    std::string text;
    std::uint64_t element = 0;
    for (const Entry& entry : entries_of(panel)) {
      const double y = title + kLegendRow * entry.row;
      text += fmt::format("<path class=\"line l{}\"{} d=\"M{:.1f} {:.1f}h20\"/>\n",
                          element % kSvgColours, dash_of(element), entry.x, y - 4);
      text += svg_label(entry.x + 26, y, "start", entry.text, "");
      ++element;
    }
    return text;
  }

  const std::vector<PlotPanel>& panels_;
  PlotRange time_;
};

}  // namespace

std::string plot_svg(const std::vector<PlotPanel>& panels, const std::string& title) {
  return Plot(panels).draw(title);
}

}  // namespace eagerx::gen
