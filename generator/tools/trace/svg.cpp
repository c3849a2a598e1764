#include "generator/tools/trace/svg.hpp"

#include <fmt/format.h>

#include <array>

#include "generator/support/quote/quote.hpp"

namespace eagerx::gen {
namespace {

// Okabe and Ito's colours, which people with colour blindness tell apart; brighter on dark paper.
constexpr std::array<const char*, kSvgColours> kLight = {"#0072b2", "#d55e00", "#009e73",
                                                         "#cc79a7", "#a07800", "#56b4e9"};
constexpr std::array<const char*, kSvgColours> kDark = {"#56b4e9", "#f0904d", "#3fd6a8",
                                                        "#e6a5c8", "#e8c33f", "#9fd6f7"};

std::string style() {
  std::string light, dark;
  for (std::size_t i = 0; i < kSvgColours; ++i) {
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

}  // namespace

std::string svg_begin(int width, int height) {
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" "
      "viewBox=\"0 0 {0} {1}\">\n{2}<rect class=\"paper\" width=\"{0}\" height=\"{1}\"/>\n",
      width, height, style());
}

std::string svg_label(double x, double y, const char* anchor, const std::string& text,
                      const std::string& look) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\"{}>{}</text>\n", x, y,
                     anchor, look.empty() ? "" : " class=\"" + look + "\"", xml_text(text));
}

}  // namespace eagerx::gen
