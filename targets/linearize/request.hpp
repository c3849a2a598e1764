// The command line of a program that is linearized.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <eagerx/channel.hpp>
#include <eagerx/math.hpp>
#include <eagerx/message.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <targets/linearize/node_system.hpp>
#include <targets/linearize/probe.hpp>
#include <targets/linearize/step_response.hpp>
#include <vector>

namespace eagerx::linearize {

/// The parsed command line, with channels by their numbers in the graph.
struct Request {
  std::uint64_t steps = 0, seed = 0;
  std::vector<std::string> at;  // NAME=VALUE,…
  std::vector<std::uint32_t> from, to;
  std::optional<std::uint32_t> open;  // what readers get of it has no derivative of what is sent
  std::size_t element = 0;            // of its messages
  std::vector<Held> held;             // actions, and what readers of other channels get
  std::vector<double> words;          // the state to begin with; empty: that after the steps
  bool compares = true;  // prints A of the next hyperperiod, too; else what the numbers become, and
                         // how they depend on a reset
  bool quantizes = true;              // else nodes that quantize pass on what they get
  std::vector<std::string> settling;  // nodes whose numbers that depend on nothing else settle
  NodeRequest node;                   // of which only this is printed
  StepRequest step;                   // at `open`; only this is printed

  /// Of a node in `settling`; -1: it is not there.
  [[nodiscard]] std::ptrdiff_t settling_index(const std::string& name) const {
    const auto found = std::find(settling.begin(), settling.end(), name);
    return found == settling.end() ? -1 : found - settling.begin();
  }
};

/// "CHANNEL:ELEMENT=VALUE"
inline std::optional<Held> read_held(const char* text) {
  Held held;
  char* end = nullptr;
  held.channel = static_cast<std::uint32_t>(std::strtoull(text, &end, 10));
  if (*end != ':') return std::nullopt;
  held.element = std::strtoull(end + 1, &end, 10);
  if (*end != '=') return std::nullopt;
  held.value = std::strtod(end + 1, &end);
  return *end == '\0' ? std::optional(held) : std::nullopt;
}

/// "0.5,-1,2"
inline std::vector<double> read_numbers(const char* text) {
  std::vector<double> numbers;
  while (*text != '\0') {
    char* end = nullptr;
    numbers.push_back(std::strtod(text, &end));
    if (end == text) return {};
    text = *end == ',' ? end + 1 : end;
  }
  return numbers;
}

/// Nothing with a message where the command line is not as eagerx-gen writes it.
inline std::optional<Request> read_request(int argc, char** argv) {
  Request request;
  for (int i = 1; i + 1 < argc; i += 2) {
    const std::string_view name = argv[i];
    const auto number = [&] { return std::strtoull(argv[i + 1], nullptr, 10); };
    const auto channel = [&] { return static_cast<std::uint32_t>(number()); };
    if (name == "--steps") {
      request.steps = number();
    } else if (name == "--seed") {
      request.seed = number();
    } else if (name == "--at") {
      request.at.emplace_back(argv[i + 1]);
    } else if (name == "--from") {
      request.from.push_back(channel());
    } else if (name == "--to") {
      request.to.push_back(channel());
    } else if (name == "--open") {
      request.open = channel();
    } else if (name == "--element") {
      request.element = number();
    } else if (name == "--words") {
      request.words = read_numbers(argv[i + 1]);
    } else if (name == "--node") {
      request.node.node = argv[i + 1];
    } else if (name == "--cut") {
      request.node.cut = channel();
    } else if (name == "--seen") {
      request.node.seen.push_back(channel());
    } else if (name == "--compares") {
      request.compares = number() != 0;
    } else if (name == "--quantizes") {
      request.quantizes = number() != 0;
    } else if (name == "--step-size") {
      request.step.size = std::strtod(argv[i + 1], nullptr);
    } else if (name == "--hyperperiods") {
      request.step.hyperperiods = number();
    } else if (name == "--settle") {
      request.settling.emplace_back(argv[i + 1]);
    } else if (const auto held = name == "--hold" ? read_held(argv[i + 1]) : std::nullopt) {
      request.held.push_back(*held);
    } else {
      std::fprintf(stderr, "error: there is no option `%s`\n", argv[i]);
      return std::nullopt;
    }
  }
  return request;
}

/// Sets a state as `--at` says; false with a message.
template <class Graph>
bool set_state(const std::string& text, typename Graph::States& states) {
  const std::size_t equals = text.find('=');
  const std::string name = text.substr(0, equals);
  bool is_known = false, fits = true;
  Graph::for_each_state([&](const char* state, const char*, auto member, const auto& space) {
    if (name != state) return;
    is_known = true;
    auto message = space.low;
    const char* rest = text.c_str() + equals + 1;
    for (std::size_t i = 0; i < size_of<decltype(message)>; ++i) {
      char* end = nullptr;
      const double value = std::strtod(rest, &end);
      fits = fits && end != rest && (*end == ',' || *end == '\0') && eagerx::isfinite(value);
      element(message, i) = static_cast<ScalarOf<decltype(message)>>(value);
      rest = *end == ',' ? end + 1 : end;
    }
    fits = fits && *rest == '\0';
    states.*member = message;
  });
  if (equals != std::string::npos && is_known && fits) return true;
  std::fprintf(
      stderr, "error: `--at %s`: %s\nhelp: states are", text.c_str(),
      is_known ? "not one finite number for each element of the state" : "there is no such state");
  const char* separator = " ";
  Graph::for_each_state([&](const char* state, const char*, auto, const auto& space) {
    std::fprintf(stderr, "%s`%s` (%zu)", separator, state, size_of<decltype(space.low)>);
    separator = ", ";
  });
  std::fprintf(stderr, "\n");
  return false;
}

}  // namespace eagerx::linearize
