#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "generator/support/quote/quote.hpp"
#include "generator/tools/trace/axis.hpp"

namespace eagerx::gen {
namespace {

constexpr int kWidth = 760, kLeft = 70, kRight = 690, kTitle = 36;
constexpr int kPanel = 150, kAbove = 24, kBottom = 40;  // a panel with its title, and the time
constexpr std::size_t kColours = 6;
// Okabe and Ito's colours, which people with colour blindness tell apart; brighter on dark paper.
constexpr std::array<const char*, kColours> kLight = {"#0072b2", "#d55e00", "#009e73",
                                                      "#cc79a7", "#a07800", "#56b4e9"};
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
    const int height = kTitle + kPanel * static_cast<int>(panels_.size()) + kBottom;
    std::string text = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" "
        "viewBox=\"0 0 {0} {1}\">\n{2}<rect class=\"paper\" width=\"{0}\" height=\"{1}\"/>\n",
        kWidth, height, style());
    text += label(kLeft, 22, "start", title, "name");
    for (std::size_t p = 0; p < panels_.size(); ++p)
      text += panel(panels_[p], kTitle + kPanel * static_cast<int>(p));
    const int bottom = height - kBottom;
    for (const PlotMark& mark : marks_of(time_, 8))
      text += label(x(mark.value), bottom + 18, "middle", mark.text, "");
    return text + label(kRight, bottom + 34, "end", "time in the episode [s]", "") + "</svg>\n";
  }

 private:
  double x(double time_s) const { return kLeft + (kRight - kLeft) * time_.share(time_s); }

  std::string panel(const PlotPanel& panel, int top) const {
    const PlotRange range = value_range(panel);
    const double from = top + kAbove, to = top + kPanel - 6;
    const auto y = [&](double value) { return to - (to - from) * range.share(value); };
    std::string text = label(kLeft, top + 16, "start", panel.title, "name");
    for (const PlotMark& mark : marks_of(range, 4)) {
      text +=
          fmt::format("<path class=\"grid\" d=\"M{} {:.1f}H{}\"/>\n", kLeft, y(mark.value), kRight);
      text += label(kLeft - 6, y(mark.value) + 4, "end", mark.text, "");
    }
    for (const PlotMark& mark : marks_of(time_, 8))
      text += fmt::format("<path class=\"grid\" d=\"M{:.1f} {:.1f}V{:.1f}\"/>\n", x(mark.value),
                          from, to);
    for (const PlotLine& line : panel.lines) text += curve(line, panel, y);
    return text + legend(panel, top + 16);
  }

  template <class Y>
  std::string curve(const PlotLine& line, const PlotPanel& panel, Y&& y) const {
    std::string points;
    for (const std::size_t i : thinned(line, time_, kRight - kLeft))
      points += fmt::format("{:.1f},{:.1f} ", x(line.time_s[i]), y(line.value[i]));
    if (points.empty()) return {};
    points.pop_back();
    const bool many = panel.lines.size() > panel.elements;
    return fmt::format("<polyline class=\"line l{}\"{} points=\"{}\"/>\n", line.element % kColours,
                       many ? " stroke-opacity=\"0.6\"" : "", points);
  }

  /// Which element has which colour.
  static std::string legend(const PlotPanel& panel, double y) {
    if (panel.elements == 1) return {};
    std::string text;
    const std::uint64_t shown = std::min<std::uint64_t>(panel.elements, kColours);
    for (std::uint64_t i = 0; i < shown; ++i)
      text += label(kRight - 30.0 * static_cast<double>(shown - 1 - i), y, "end",
                    fmt::format("[{}]", i), fmt::format("t{}", i));
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
