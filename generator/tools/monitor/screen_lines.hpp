// The contents of a screen as lines of text, independent of a terminal.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "generator/tools/monitor/keys.hpp"
#include "generator/tools/monitor/model.hpp"

namespace eagerx::gen {

/// How a part of a line looks. Color alone carries no information: not every terminal has colors.
enum class Ink : std::uint8_t { plain, title, head, dim, selected, warning };

struct InkedText {
  std::string text;
  Ink ink = Ink::plain;
};
using ScreenLine = std::vector<InkedText>;

struct ScreenSize {
  std::size_t rows = 24, columns = 80;
  bool unicode = true;  // blocks for plots
};
inline constexpr std::size_t kLeastRows = 8, kLeastColumns = 40;

/// One line for each row, at most as wide as the screen. `source`: as the user wrote it; `note`:
/// its state, for example that it has ended. Keeps the selected row visible.
std::vector<ScreenLine> screen_lines(const Model& model, ScreenView& view, const ScreenSize& size,
                                     const std::string& source, const std::string& note);

/// `text` in exactly `columns` columns: cut, or filled up with blanks.
std::string fitted(std::string_view text, std::size_t columns, bool to_the_right = false);

}  // namespace eagerx::gen
