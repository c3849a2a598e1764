#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "generator/tools/trace/axis.hpp"

namespace eagerx::gen {
namespace {

constexpr std::size_t kRows = 8;     // of characters, a panel
constexpr std::size_t kMargin = 12;  // for the numbers at the left

/// Dots in characters: 2x4 in one of Braille, one in one of ASCII.
class Dots {
 public:
  Dots(std::size_t columns, bool braille)
      : columns_(columns), braille_(braille), cells_(columns * kRows) {}

  std::size_t width() const { return columns_ * (braille_ ? 2 : 1); }
  std::size_t height() const { return kRows * (braille_ ? 4 : 1); }

  void set(std::size_t x, std::size_t y) {
    if (!braille_) {
      cells_[y * columns_ + x] = 1;
      return;
    }
    // U+2800: dots 1, 2, 3, 7 on the left, 4, 5, 6, 8 on the right.
    constexpr std::uint8_t kBits[4][2] = {{0x01, 0x08}, {0x02, 0x10}, {0x04, 0x20}, {0x40, 0x80}};
    cells_[y / 4 * columns_ + x / 2] |= kBits[y % 4][x % 2];
  }
  void line(std::size_t x, std::size_t from, std::size_t to) {
    for (std::size_t y = std::min(from, to); y <= std::max(from, to); ++y) set(x, y);
  }

  std::string row(std::size_t y) const {
    std::string text;
    for (std::size_t x = 0; x < columns_; ++x) {
      const std::uint8_t cell = cells_[y * columns_ + x];
      if (!braille_) {
        text += cell != 0 ? '*' : ' ';
      } else if (cell == 0) {
        text += ' ';
      } else {
        const unsigned code = 0x2800U + cell;
        text +=
            {static_cast<char>(0xe0U | code >> 12U), static_cast<char>(0x80U | (code >> 6U & 63U)),
             static_cast<char>(0x80U | (code & 63U))};
      }
    }
    text.erase(text.find_last_not_of(' ') + 1);
    return text;
  }

 private:
  std::size_t columns_;
  bool braille_;
  std::vector<std::uint8_t> cells_;
};

/// The column or row of a share from 0 to 1.
std::size_t place(double share, std::size_t size) {
  const double wanted = share * static_cast<double>(size - 1) + 0.5;
  return std::min(static_cast<std::size_t>(std::max(wanted, 0.0)), size - 1);
}

/// Straight from each point to the next.
void draw(const PlotLine& line, const PlotRange& time, const PlotRange& range, Dots& dots) {
  std::size_t x = 0, y = 0;
  for (std::size_t i = 0; i < line.value.size(); ++i) {
    const std::size_t to_x = place(time.share(line.time_s[i]), dots.width());
    const std::size_t to_y = place(1.0 - range.share(line.value[i]), dots.height());
    if (i == 0 || to_x <= x) {
      dots.line(to_x, i == 0 ? to_y : y, to_y);
    } else {
      const double slope =
          (static_cast<double>(to_y) - static_cast<double>(y)) / static_cast<double>(to_x - x);
      std::size_t before = y;
      for (std::size_t column = x + 1; column <= to_x; ++column) {
        const double rise = slope * static_cast<double>(column - x);
        const auto now = static_cast<std::size_t>(std::floor(static_cast<double>(y) + rise + 0.5));
        dots.line(column, before, now);
        before = now;
      }
    }
    x = to_x;
    y = to_y;
  }
}

std::string panel_text(const PlotPanel& panel, const PlotRange& time, std::size_t columns,
                       bool braille) {
  const PlotRange range = value_range(panel);
  Dots dots(columns - kMargin, braille);
  for (const PlotLine& line : panel.lines) draw(line, time, range, dots);
  std::string text = panel.title + (panel.unit.empty() ? "" : " [" + panel.unit + "]") + "\n";
  for (std::size_t y = 0; y < kRows; ++y) {
    const std::string number = y == 0           ? fmt::format("{:.4g}", range.high)
                               : y == kRows - 1 ? fmt::format("{:.4g}", range.low)
                                                : "";
    text += fmt::format("{:>{}} {}{}\n", number, kMargin - 2, braille ? "▏" : "|", dots.row(y));
  }
  return text;
}

}  // namespace

std::string plot_text(const std::vector<PlotPanel>& panels, std::size_t columns, bool braille) {
  const PlotRange time = time_range(panels);
  columns = std::max(columns, 2 * kMargin);
  std::string text;
  for (const PlotPanel& panel : panels) text += panel_text(panel, time, columns, braille);
  const std::string end = fmt::format("{:.4g} s", time.high);
  return text + fmt::format("{:>{}}{:>{}}\n", "0", kMargin + 1, end, columns - kMargin - 1);
}

}  // namespace eagerx::gen
