// The terminal, drawn by ncurses. No other part of the generator uses ncurses.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "generator/tools/monitor/keys.hpp"
#include "generator/tools/monitor/screen_lines.hpp"

namespace eagerx::gen {

class Screen {
 public:
  virtual ~Screen() = default;  // the terminal is as it was before
  virtual ScreenSize size() = 0;
  virtual void draw(const std::vector<ScreenLine>& lines) = 0;
  /// The typed keys, one after the other. Nothing: no more.
  virtual std::optional<KeyPress> key() = 0;
};

/// Takes the terminal of the standard input and output. Null: `problem` says why not.
std::unique_ptr<Screen> open_screen(std::string& problem);

}  // namespace eagerx::gen
