// Keys that a person presses.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "generator/tools/monitor/model.hpp"

namespace eagerx::gen {

enum class Key : std::uint8_t {
  character,
  enter,
  escape,
  backspace,
  up,
  down,
  page_up,
  page_down,
  home,
  end
};

struct KeyPress {
  Key key = Key::character;
  char character = 0;  // ASCII
};

/// The shown part of a model.
struct ScreenView {
  bool paused = false, helps = false, types_filter = false, ends = false;
  std::string filter;                 // what names contain
  std::optional<std::string> zoomed;  // a channel that is shown alone
  std::size_t selected = 0;           // of the channels that the filter leaves
  std::size_t first = 0;              // row that is the uppermost
  std::size_t rows = 1;               // that fit, as last drawn
};

/// The channels that the filter leaves, by their places in the model.
std::vector<std::size_t> shown_channels(const Model& model, const std::string& filter);

void press(const KeyPress& press, const Model& model, ScreenView& view);

}  // namespace eagerx::gen
