#include "checker.hpp"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <utility>

namespace eagerx::conformance {
namespace {

constexpr double kStampTolerance_s = 1e-12;  // EAGERx rounds stamps to 12 decimals

/// As Python's round(value, 12).
double rounded(double value) {
  char text[64];
  std::snprintf(text, sizeof text, "%.12f", value);
  return std::strtod(text, nullptr);
}

std::string text_of(double value) {
  char text[64];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}
std::string text_of(std::uint64_t value) {
  return std::to_string(value);
}

template <class T>
std::string list_of(const std::vector<T>& values) {
  std::string text = "[";
  for (const T value : values) text += (text.size() > 1 ? ", " : "") + text_of(value);
  return text + "]";
}

}  // namespace

void Checker::differ(const Place& place, const std::string& field, std::size_t line,
                     const std::string& expected, const std::string& seen) const {
  std::printf(
      "DIFFERENT: node %s, episode %u, tick %llu, %s\n  expected %s (%s:%zu)\n  got      %s\n",
      place.node.c_str(), index_, static_cast<unsigned long long>(place.tick), field.c_str(),
      expected.c_str(), recording_.path.c_str(), line, seen.c_str());
  std::exit(1);
}

void Checker::begin_episode(std::uint32_t index) {
  index_ = index;
}

RecordedTick& Checker::recorded(const Place& place, std::string_view what) {
  auto& ticks = recording_.episodes[index_].ticks;
  const auto tick = ticks.find({place.node, place.tick});
  if (tick == ticks.end()) differ(place, std::string(what), 0, "no such tick", "one");
  return tick->second;
}

void Checker::inputs(const Place& place, double time_s, const std::vector<SeenWindow>& windows) {
  RecordedTick& tick = recorded(place, "inputs");
  if (tick.seen) differ(place, "callback", tick.line, "one", "a second one");
  tick.seen = true;
  ++ticks_;
  if (rounded(time_s) != tick.time_s) {
    differ(place, "t_n", tick.line, text_of(tick.time_s), text_of(rounded(time_s)));
  }
  for (const SeenWindow& window : windows) {
    const auto expected = tick.inputs.find(window.name);
    if (expected == tick.inputs.end())
      differ(place, "input " + window.name, tick.line, "none", "one");
    compare_window(place, expected->second, window);
  }
  if (windows.size() != tick.inputs.size()) {
    differ(place, "number of inputs", tick.line, text_of(std::uint64_t{tick.inputs.size()}),
           text_of(std::uint64_t{windows.size()}));
  }
}

void Checker::compare_window(const Place& place, const RecordedWindow& expected,
                             const SeenWindow& seen) {
  const std::string field = "input " + seen.name;
  if (seen.seq.size() != expected.seq.size()) {
    differ(place, field + ", number of messages", expected.line,
           text_of(std::uint64_t{expected.seq.size()}), text_of(std::uint64_t{seen.seq.size()}));
  }
  if (seen.seq != expected.seq)
    differ(place, field + ", seq", expected.line, list_of(expected.seq), list_of(seen.seq));
  for (std::size_t i = 0; i < seen.sent_s.size(); ++i) {
    if (std::abs(seen.sent_s[i] - expected.sent_s[i]) <= kStampTolerance_s) continue;
    differ(place, field + ", sent", expected.line, list_of(expected.sent_s), list_of(seen.sent_s));
  }
  compare_values(place, seen.name, expected.line, expected.values, seen.values);
  ++windows_;
  received_ += seen.seq.size();
}

void Checker::compare_values(const Place& place, const std::string& port, std::size_t line,
                             const std::vector<double>& expected, const std::vector<double>& seen) {
  if (expected.size() != seen.size())
    differ(place, port + ", values", line, list_of(expected), list_of(seen));
  const std::string name = place.node + "." + port;
  const auto tolerances = recording_.tolerances.find(name);
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const double tolerance = recording_.tolerance(name, i);
    const bool both_nan = std::isnan(expected[i]) && std::isnan(seen[i]);
    const double deviation = both_nan ? 0.0 : std::abs(expected[i] - seen[i]);
    if (!(deviation <= tolerance)) {
      differ(place, port + ", element " + text_of(std::uint64_t{i}), line, text_of(expected[i]),
             text_of(seen[i]));
    }
    if (tolerances == recording_.tolerances.end()) continue;
    const std::size_t place_in_message = i % tolerances->second.size();
    Deviation& largest = deviations_[name + "[" + std::to_string(place_in_message) + "]"];
    largest.tolerance = tolerance;
    if (deviation > largest.largest) largest = {deviation, tolerance, index_, place.tick};
  }
}

void Checker::output(const Place& place, const std::string& port,
                     const std::vector<double>& values) {
  RecordedTick& tick = recorded(place, "output " + port);
  const auto expected = tick.outputs.find(port);
  if (expected == tick.outputs.end())
    differ(place, "output " + port, tick.line, "none", list_of(values));
  compare_values(place, port, expected->second.line, expected->second.values, values);
  if (tick.inputs.empty() && !tick.seen) {
    tick.seen = true;
    ++ticks_;
  }
  ++tick.seen_outputs;
  ++sent_;
}

void Checker::observation(std::uint64_t tick, const std::string& name,
                          const std::vector<double>& values) {
  const Place place{"environment", tick};
  const RecordedTick& recorded_tick = recorded(place, "observation");
  const auto expected = recorded_tick.observations.find(name);
  if (expected == recorded_tick.observations.end()) {
    differ(place, "observation " + name, recorded_tick.line, "none", list_of(values));
  }
  compare_values(place, name, expected->second.line, expected->second.values, values);
}

void Checker::end_episode(std::uint64_t steps) {
  const Place last{"environment", steps};
  const double end_s = recorded(last, "last tick").time_s;
  for (const auto& [key, tick] : recording_.episodes[index_].ticks) {
    if (tick.time_s > end_s) continue;
    const Place place{key.first, key.second};
    if (!tick.seen) differ(place, "callback", tick.line, "one", "none");
    if (tick.seen_outputs != tick.outputs.size()) {
      differ(place, "number of outputs", tick.line, text_of(std::uint64_t{tick.outputs.size()}),
             text_of(std::uint64_t{tick.seen_outputs}));
    }
  }
}

void Checker::report() const {
  std::printf(
      "equal: %zu episodes, %llu ticks, %llu inputs with %llu messages, %llu messages sent\n",
      recording_.episodes.size(), static_cast<unsigned long long>(ticks_),
      static_cast<unsigned long long>(windows_), static_cast<unsigned long long>(received_),
      static_cast<unsigned long long>(sent_));
  for (const auto& [port, deviation] : deviations_) {
    std::printf("largest deviation of %s: %.3g (tolerance %g; episode %u, tick %llu)\n",
                port.c_str(), deviation.largest, deviation.tolerance, deviation.episode,
                static_cast<unsigned long long>(deviation.tick));
  }
}

}  // namespace eagerx::conformance
