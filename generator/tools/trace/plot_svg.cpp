#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "generator/support/quote/quote.hpp"
#include "generator/tools/trace/axis.hpp"

namespace eagerx::gen {
namespace {

constexpr int kWidth = 760, kLeft = 70, kRight = 690, kTitle = 36;
// A panel with its title and legend, and the time.
constexpr int kPanel = 150, kAbove = 24, kBottom = 40, kLegendRow = 16;
constexpr std::size_t kMostInLegend = 17;
constexpr std::size_t kColours = 6;
// Okabe and Ito's colours, which people with colour blindness tell apart; brighter on dark paper.
constexpr std::array<const char*, kColours> kLight = {"#0072b2", "#d55e00", "#009e73",
                                                      "#cc79a7", "#a07800", "#56b4e9"};
// From the seventh element on, dashes tell lines of one colour apart.
constexpr std::array<const char*, 3> kDashes = {"", "6 3", "2 2"};
constexpr std::array<const char*, kColours> kDark = {"#56b4e9", "#f0904d", "#3fd6a8",
                                                     "#e6a5c8", "#e8c33f", "#9fd6f7"};

std::string style() {
  std::string light, dark;
  for (std::size_t i = 0; i < kColours; ++i) {
    light += fmt::format(".l{0}{{stroke:{1}}}.t{0}{{fill:{1}}}", i, kLight[i]);
    dark += fmt::format(".l{0}{{stroke:{1}}}.t{0}{{fill:{1}}}", i, kDark[i]);
  }
  return fmt::format(
      "<style>text{{font:12px system-ui,'Segoe UI',Roboto,'Liberation Sans',Arial,sans-serif;"
      "fill:#475467}}.name{{font-weight:600;fill:#1d2939}}.paper{{fill:#fff}}"
      ".grid{{stroke:#e4e7ec}}.line{{fill:none;stroke-width:1.5;stroke-linejoin:round}}{}"
      "@media(prefers-color-scheme:dark){{text{{fill:#98a2b3}}.name{{fill:#f2f4f7}}"
      ".paper{{fill:#101828}}.grid{{stroke:#344054}}{}}}</style>\n",
      light, dark);
}

std::string label(double x, double y, const char* anchor, const std::string& text,
                  const std::string& look) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\"{}>{}</text>\n", x, y,
                     anchor, look.empty() ? "" : " class=\"" + look + "\"", xml_text(text));
}

class Plot {
 public:
  explicit Plot(const std::vector<PlotPanel>& panels)
      : panels_(panels), time_(time_range(panels)) {}

  std::string draw(const std::string& title) {
    int height = kTitle + kBottom;
    for (const PlotPanel& each : panels_) height += kPanel + kLegendRow * rows_of_legend(each);
    std::string text = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" "
        "viewBox=\"0 0 {0} {1}\">\n{2}<rect class=\"paper\" width=\"{0}\" height=\"{1}\"/>\n",
        kWidth, height, style());
    text += label(kLeft, 22, "start", title, "name");
    int top = kTitle;
    for (const PlotPanel& each : panels_) {
      const int rows = rows_of_legend(each);
      text += panel(each, top, top + kLegendRow * rows);
      top += kPanel + kLegendRow * rows;
    }
    const int bottom = height - kBottom;
    for (const PlotMark& mark : marks_of(time_, 8))
      text += label(x(mark.value), bottom + 18, "middle", mark.text, "");
    return text + label(kRight, bottom + 34, "end", "time in the episode [s]", "") + "</svg>\n";
  }

 private:
  double x(double time_s) const { return kLeft + (kRight - kLeft) * time_.share(time_s); }

  /// Of the plot, which begins at `top`, below the title at `title` and the legend.
  std::string panel(const PlotPanel& panel, int title, int top) const {
    const PlotRange range = value_range(panel);
    const double from = top + kAbove, to = top + kPanel - 6;
    const auto y = [&](double value) { return to - (to - from) * range.share(value); };
    std::string text = label(kLeft, title + 16, "start", panel.title, "name");
    for (const PlotMark& mark : marks_of(range, 4)) {
      text +=
          fmt::format("<path class=\"grid\" d=\"M{} {:.1f}H{}\"/>\n", kLeft, y(mark.value), kRight);
      text += label(kLeft - 6, y(mark.value) + 4, "end", mark.text, "");
    }
    for (const PlotMark& mark : marks_of(time_, 8))
      text += fmt::format("<path class=\"grid\" d=\"M{:.1f} {:.1f}V{:.1f}\"/>\n", x(mark.value),
                          from, to);
    for (const PlotLine& line : panel.lines) text += curve(line, panel, y);
    return text + legend(panel, title + 16);
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
                       line.element % kColours, dash_of(line.element),
                       many ? " stroke-opacity=\"0.6\"" : "", points);
  }

  static std::string dash_of(std::uint64_t element) {
    const char* const dash = kDashes[element / kColours % kDashes.size()];
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
                          element % kColours, dash_of(element), entry.x, y - 4);
      text += label(entry.x + 26, y, "start", entry.text, "");
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
