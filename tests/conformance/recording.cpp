#include "recording.hpp"

#include <charconv>
#include <cstdio>
#include <fstream>
#include <limits>
#include <string_view>

namespace eagerx::conformance {
namespace {

std::vector<std::string_view> split(std::string_view line) {
  std::vector<std::string_view> cells;
  for (;;) {
    const std::size_t comma = line.find(',');
    cells.push_back(line.substr(0, comma));
    if (comma == std::string_view::npos) return cells;
    line.remove_prefix(comma + 1);
  }
}

template <class T>
bool to_number(std::string_view text, T& value) {
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  return result.ec == std::errc() && result.ptr == text.data() + text.size();
}

/// Numbers from `begin` to `end`; false if one is none.
template <class T>
bool to_numbers(const std::vector<std::string_view>& cells, std::size_t begin, std::size_t end,
                std::vector<T>& values) {
  if (begin > end || end > cells.size()) return false;
  values.resize(end - begin);
  for (std::size_t i = begin; i < end; ++i) {
    if (!to_number(cells[i], values[i - begin])) return false;
  }
  return true;
}

/// Reads line by line; a line belongs to the last `episode` and the last `tick`.
class Reader {
 public:
  explicit Reader(Recording& recording) : recording_(recording) {}

  bool line(std::size_t number, std::string_view text) {
    number_ = number;
    const auto cells = split(text);
    const std::string_view kind = cells[0];
    if (kind == "episode") return cells.size() == 1 && (recording_.episodes.emplace_back(), true);
    if (kind == "tolerance") return tolerance(cells);
    if (recording_.episodes.empty()) return false;
    if (kind == "tick") return tick(cells);
    if (cells.size() < 2) return false;
    const std::string name(cells[1]);
    if (kind == "state") return message(cells, recording_.episodes.back().states[name]);
    if (tick_ == nullptr) return false;
    if (kind == "in") return window(cells, tick_->inputs[name]);
    if (kind == "out") return message(cells, tick_->outputs[name]);
    if (kind == "obs") return message(cells, tick_->observations[name]);
    return false;
  }

 private:
  bool tolerance(const std::vector<std::string_view>& cells) {
    return cells.size() > 2 &&
           to_numbers(cells, 2, cells.size(), recording_.tolerances[std::string(cells[1])]);
  }

  bool tick(const std::vector<std::string_view>& cells) {
    std::uint64_t n = 0;
    if (cells.size() != 4 || !to_number(cells[2], n)) return false;
    tick_ = &recording_.episodes.back().ticks[{std::string(cells[1]), n}];
    tick_->line = number_;
    return to_number(cells[3], tick_->time_s);
  }

  // in,NAME,COUNT,SEQ…,SENT…,VALUES…
  bool window(const std::vector<std::string_view>& cells, RecordedWindow& window) const {
    std::size_t count = 0;
    if (cells.size() < 3 || !to_number(cells[2], count)) return false;
    window.line = number_;
    constexpr std::size_t kFirst = 3;
    return to_numbers(cells, kFirst, kFirst + count, window.seq) &&
           to_numbers(cells, kFirst + count, kFirst + 2 * count, window.sent_s) &&
           to_numbers(cells, kFirst + 2 * count, cells.size(), window.values);
  }

  // KIND,NAME,VALUES…
  bool message(const std::vector<std::string_view>& cells, RecordedMessage& message) const {
    message.line = number_;
    return to_numbers(cells, 2, cells.size(), message.values);
  }

  Recording& recording_;
  RecordedTick* tick_ = nullptr;
  std::size_t number_ = 0;
};

}  // namespace

const RecordedTick* RecordedEpisode::action(std::uint64_t step) const {
  const auto tick = ticks.find({"environment", step});
  return tick == ticks.end() || tick->second.outputs.empty() ? nullptr : &tick->second;
}

double Recording::tolerance(const std::string& port, std::size_t i) const {
  const auto found = tolerances.find(port);
  return found == tolerances.end() ? 0.0 : found->second[i % found->second.size()];
}

std::optional<Recording> read_recording(const std::string& path) {
  std::ifstream file(path);
  Recording recording;
  recording.path = path;
  Reader reader(recording);
  std::string line;
  std::size_t number = 0;
  while (std::getline(file, line)) {
    ++number;
    if (line.empty() || line.front() == '#') continue;
    if (reader.line(number, line)) continue;
    std::fprintf(stderr, "error: %s:%zu is no line of a recording: %s\n", path.c_str(), number,
                 line.c_str());
    return std::nullopt;
  }
  if (!recording.episodes.empty()) return recording;
  std::fprintf(stderr, "error: cannot read a recording from `%s`\n", path.c_str());
  return std::nullopt;
}

}  // namespace eagerx::conformance
