#include "generator/tools/monitor/screen_lines.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/support/diagnostics/search.hpp"
#include "generator/support/diagnostics/utf8.hpp"
#include "generator/tools/monitor/columns.hpp"
#include "generator/tools/monitor/numbers.hpp"

namespace eagerx::gen {
namespace {

constexpr const char* kKeys = " space pause  / filter  enter zoom  ? help  q quit";

std::size_t width_of(std::string_view text) {
  std::size_t width = 0;
  for (std::size_t at = 0; at < text.size();) {
    const CodePoint point = decode_utf8(text, at);
    width += display_width(point.value);
    at += point.size;
  }
  return width;
}

ScreenLine title_line(const Model& model, const std::string& source, std::size_t columns) {
  std::string graph = model.facts().graph;
  if (graph.empty() && model.expected() != nullptr) graph = model.expected()->graph;
  if (model.facts().hash) graph += fmt::format(" 0x{:016x}", *model.facts().hash);
  graph = escape_unprintable(graph);
  const std::size_t right = std::min(width_of(graph), columns / 2);
  return {{fitted(" eagerx-gen monitor " + source, columns - right - 1) + " " +
               fitted(graph, right, true),
           Ink::title}};
}

ScreenLine step_line(const Model& model, std::size_t columns) {
  const StreamStep& step = model.last_step();
  std::string text = fmt::format(" episode {}", step.episode);
  if (step.step) text += fmt::format("  step {}", *step.step);
  text += fmt::format("  {:.2f} s", static_cast<double>(step.time_ns) / kNsInSecond);
  if (const auto hz = model.steps_hz(); hz && step.step)
    text += fmt::format("  {} steps/s", rate_text(*hz));
  if (const auto speed = model.speed()) text += fmt::format("  x{:.3g}", *speed);
  text += fmt::format("  late {}, worst {}",
                      duration_text(static_cast<double>(model.late_ns()) / kNsInSecond),
                      duration_text(static_cast<double>(model.worst_late_ns()) / kNsInSecond));
  return {{fitted(model.has_messages() ? text : "", columns)}};
}

ScreenLine status_line(const Model& model, const ScreenView& view, const std::string& note,
                       std::size_t columns) {
  constexpr double kLongS = 2.0;
  std::string text;
  const auto add = [&](const std::string& part) { text += (text.empty() ? " " : ", ") + part; };
  if (view.paused) add("PAUSED");
  if (!note.empty()) add(note.substr(0, note.find('\n')));
  if (!model.refusal().empty()) add(model.refusal());
  if (!model.has_messages() && note.empty()) add("waiting for messages");
  if (const auto age = model.age_s(); age && *age > kLongS && note.empty())
    add(fmt::format("nothing for {}", duration_text(*age)));
  for (std::size_t i = 0; i < kStreamFaults; ++i) {
    const auto fault = static_cast<StreamFault>(i);
    if (model.faults(fault) > 0) add(fmt::format("{} {}", text_of(fault), model.faults(fault)));
  }
  return {{fitted(text, columns), Ink::warning}};
}

std::vector<ScreenLine> help_lines(std::size_t columns) {
  std::vector<ScreenLine> lines;
  for (const char* const text :
       {" space            pause: the screen stands still, messages are counted on",
        " /                show channels whose names contain what is typed",
        " up, down         choose a channel; page up, page down, home, end",
        " enter            show all elements of the channel; again: back",
        " escape           back; without filter", " q                quit", "",
        " HZ/PLAN          messages a second, and as the graph plans",
        " AGE              since the last message",
        " LIMIT            the limit that is nearest, and how much of the range",
        "                  is left; `safe`: the safe action",
        " late             behind the graph's clock, against the earliest",
        "                  message of the episode"})
    lines.push_back({{fitted(text, columns)}});
  return lines;
}

class Page {
 public:
  Page(const Model& model, ScreenView& view, const ScreenSize& size)
      : model_(model), view_(view), size_(size) {}

  /// The rows between the status and the keys; `place_` says where they are.
  std::vector<ScreenLine> body(std::size_t rows) {
    if (view_.helps) return help_lines(size_.columns);
    const auto& channels = model_.channels();
    if (view_.zoomed) {
      const auto found = ranges::find(channels, *view_.zoomed, &WatchedChannel::name);
      if (found != channels.end()) return zoomed(*found, rows);
      view_.zoomed.reset();
    }
    return table(rows);
  }
  [[nodiscard]] const std::string& place() const { return place_; }

 private:
  std::vector<ScreenLine> zoomed(const WatchedChannel& channel, std::size_t rows) {
    constexpr std::size_t kHead = 3;
    view_.rows = rows - kHead;
    const std::size_t count = channel.values.size();
    view_.first = std::min(view_.first, count > view_.rows ? count - view_.rows : 0);
    say_place(view_.first, view_.rows, count);
    return zoomed_lines(model_, channel, view_.first, rows, size_);
  }

  std::vector<ScreenLine> table(std::size_t rows) {
    const auto shown = shown_channels(model_, view_.filter);
    const TableColumns widths = table_columns(size_.columns);
    view_.rows = rows - 1;
    view_.selected = std::min(view_.selected, shown.empty() ? 0 : shown.size() - 1);
    view_.first = std::min(view_.first, shown.size() > view_.rows ? shown.size() - view_.rows : 0);
    view_.first = std::min(view_.first, view_.selected);
    if (view_.selected >= view_.first + view_.rows) view_.first = view_.selected - view_.rows + 1;
    std::vector<ScreenLine> lines = {table_head(widths)};
    for (std::size_t i = view_.first; i < shown.size() && lines.size() < rows; ++i)
      lines.push_back(table_row(model_, model_.channels()[shown[i]], widths, i == view_.selected,
                                size_.unicode));
    say_place(view_.first, view_.rows, shown.size());
    return lines;
  }

  void say_place(std::size_t first, std::size_t rows, std::size_t count) {
    place_ = count == 0
                 ? "0 of 0"
                 : fmt::format("{}-{} of {}", first + 1, std::min(first + rows, count), count);
  }

  const Model& model_;
  ScreenView& view_;
  const ScreenSize& size_;
  std::string place_;
};

ScreenLine foot_line(const ScreenView& view, const std::string& place, std::size_t columns) {
  const std::size_t right = std::min(place.size() + 1, columns);
  std::string left = view.zoomed ? " enter back  up, down  space pause  ? help  q quit" : kKeys;
  if (view.helps) left = " any key: back";
  if (view.types_filter) {
    left = " filter: " + view.filter + "_  enter keeps it, escape ends it";
  } else if (!view.filter.empty() && !view.zoomed && !view.helps) {
    left = " filter: " + view.filter + "  (/ another, escape none)";
  }
  return {{fitted(left, columns - right) + fitted(place, right, true), Ink::head}};
}

}  // namespace

std::string fitted(std::string_view text, std::size_t columns, bool to_the_right) {
  const std::string safe = escape_unprintable(text);
  std::string result;
  std::size_t width = 0;
  const bool cut = width_of(safe) > columns;
  const std::size_t room = cut && columns > 0 ? columns - 1 : columns;
  for (std::size_t at = 0; at < safe.size();) {
    const CodePoint point = decode_utf8(safe, at);
    const std::size_t wide = display_width(point.value);
    if (width + wide > room) break;
    result += safe.substr(at, point.size);
    width += wide;
    at += point.size;
  }
  if (cut && columns > 0) {
    result += '~';
    ++width;
  }
  const std::string blanks(columns > width ? columns - width : 0, ' ');
  return to_the_right ? blanks + result : result + blanks;
}

std::vector<ScreenLine> screen_lines(const Model& model, ScreenView& view, const ScreenSize& size,
                                     const std::string& source, const std::string& note) {
  if (size.rows < kLeastRows || size.columns < kLeastColumns)
    return {{{fitted(fmt::format("{}x{} at least", kLeastColumns, kLeastRows), size.columns)}}};
  constexpr std::size_t kAround = 4;  // title, step, status, keys
  std::vector<ScreenLine> lines = {title_line(model, source, size.columns),
                                   step_line(model, size.columns),
                                   status_line(model, view, note, size.columns)};
  Page page(model, view, size);
  for (ScreenLine& line : page.body(size.rows - kAround)) {
    if (lines.size() < size.rows - 1) lines.push_back(std::move(line));
  }
  lines.resize(size.rows - 1);
  lines.push_back(foot_line(view, page.place(), size.columns));
  return lines;
}

}  // namespace eagerx::gen
