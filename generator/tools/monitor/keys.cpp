#include "generator/tools/monitor/keys.hpp"

#include <algorithm>

#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

constexpr std::size_t kLongestFilter = 60;

void type(const KeyPress& press, ScreenView& view) {
  if (press.key == Key::enter) {
    view.types_filter = false;
  } else if (press.key == Key::escape) {
    view.types_filter = false;
    view.filter.clear();
  } else if (press.key == Key::backspace) {
    if (!view.filter.empty()) view.filter.pop_back();
  } else if (press.key == Key::character && view.filter.size() < kLongestFilter) {
    view.filter += press.character;
  }
  view.selected = view.first = 0;
}

/// Up and down, of rows of which there are `count`; true if the key was one of these.
bool travel(Key key, std::size_t count, std::size_t page, std::size_t& at) {
  const std::size_t last = count == 0 ? 0 : count - 1;
  switch (key) {
    case Key::up:
      at -= at > 0 ? 1 : 0;
      return true;
    case Key::down:
      at = std::min(at + 1, last);
      return true;
    case Key::page_up:
      at -= std::min(at, page);
      return true;
    case Key::page_down:
      at = std::min(at + page, last);
      return true;
    case Key::home:
      at = 0;
      return true;
    case Key::end:
      at = last;
      return true;
    default:
      return false;
  }
}

void command(char character, ScreenView& view) {
  if (character == 'q') view.ends = true;
  if (character == ' ') view.paused = !view.paused;
  if (character == '?') view.helps = true;
  if (character == '/') {
    view.types_filter = true;
    view.zoomed.reset();
  }
}

}  // namespace

std::vector<std::size_t> shown_channels(const Model& model, const std::string& filter) {
  std::vector<std::size_t> shown;
  for (std::size_t i = 0; i < model.channels().size(); ++i) {
    if (model.channels()[i].name.find(filter) != std::string::npos) shown.push_back(i);
  }
  return shown;
}

void press(const KeyPress& press, const Model& model, ScreenView& view) {
  if (view.helps) {
    view.helps = false;
    view.ends = press.key == Key::character && press.character == 'q';
    return;
  }
  if (view.types_filter) return type(press, view);
  if (press.key == Key::character) return command(press.character, view);
  const auto shown = shown_channels(model, view.filter);
  view.selected = std::min(view.selected, shown.empty() ? 0 : shown.size() - 1);
  if (view.zoomed) {
    const auto channel = ranges::find(model.channels(), *view.zoomed, &WatchedChannel::name);
    const std::size_t rows = channel == model.channels().end() ? 0 : channel->values.size();
    if (travel(press.key, rows, view.rows, view.first)) return;
    view.zoomed.reset();  // enter, escape
    view.first = 0;
    return;
  }
  if (travel(press.key, shown.size(), view.rows, view.selected)) return;
  if (press.key == Key::escape) view.filter.clear();
  if (press.key == Key::enter && !shown.empty()) {
    view.zoomed = model.channels()[shown[view.selected]].name;
    view.first = 0;
  }
}

}  // namespace eagerx::gen
