// Drives a generated program with the states and actions of a recording and compares everything.
#pragma once

#include <cstdint>
#include <cstdio>
#include <eagerx/message.hpp>
#include <eagerx/rate.hpp>
#include <memory>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "checker.hpp"

namespace eagerx::conformance {

template <class Message>
void append(std::vector<double>& values, const Message& message) {
  for (std::size_t i = 0; i < size_of<Message>; ++i)
    values.push_back(static_cast<double>(element(message, i)));
}

template <class Message>
void assign(Message& message, const std::vector<double>& values) {
  for (std::size_t i = 0; i < size_of<Message> && i < values.size(); ++i) {
    element(message, i) = static_cast<ScalarOf<Message>>(values[i]);
  }
}

template <class Window>
SeenWindow seen_window(const char* name, const Window& window) {
  SeenWindow seen;
  seen.name = name;
  for (std::uint32_t i = 0; i < window.size(); ++i) {
    seen.seq.push_back(window.seq(i));
    seen.sent_s.push_back(window.template sent_s<double>(i));
    append(seen.values, window[i]);
  }
  return seen;
}

/// Hands everything that the program shows of itself to a Checker.
template <class Graph>
struct CheckingTrace {
  static constexpr bool kInputs = true;
  Checker* checker = nullptr;

  void episode(std::uint32_t index) { checker->begin_episode(index); }

  template <class Message>
  void operator()(std::uint32_t channel, Seq seq, const Message& message) {
    const std::string name = Graph::kChannels[channel];
    const std::size_t slash = name.rfind('/');
    std::vector<double> values;
    append(values, message);
    checker->output({name.substr(0, slash), seq}, name.substr(slash + 1), values);
  }

  template <class NodeRate, class Inputs>
  void inputs(const char* node, NodeRate /*rate*/, Seq tick, const Inputs& inputs) {
    std::vector<SeenWindow> windows;
    inputs.for_each([&](const char* name, const auto& window) {
      if constexpr (requires { window.unpadded(); }) {
        windows.push_back(seen_window(name, window.unpadded()));
      } else {
        windows.push_back(seen_window(name, window));
      }
    });
    checker->inputs({node, tick}, NodeRate::template seconds<double>(tick), windows);
  }
};

template <class Observation>
void check_observation(Checker& checker, std::uint64_t tick, const Observation& observation) {
  observation.for_each([&](const char* name, const auto& window) {
    std::vector<double> values;
    for (std::uint32_t i = 0; i < window.size(); ++i) append(values, window[i]);
    checker.observation(tick, name, values);
  });
}

template <class Graph, class Program>
void run_episode(Program& program, Checker& checker, const RecordedEpisode& episode) {
  typename Graph::States states;
  states.for_each([&](const char* name, auto& state) {
    const auto value = episode.states.find(name);
    if (value == episode.states.end()) return;
    state.emplace();
    assign(*state, value->second.values);
  });
  check_observation(checker, 0, program.reset(states));
  std::uint64_t step = 0;
  for (; const RecordedTick* tick = episode.action(step); ++step) {
    typename Graph::Action action{};
    Graph::for_each_action(action, [&](const char* name, auto& message, const auto& /*space*/) {
      const auto value = tick->outputs.find(name);
      if (value != tick->outputs.end()) assign(message, value->second.values);
    });
    check_observation(checker, step + 1, program.step(action));
  }
  checker.end_episode(step);
}

/// The main function: `PROGRAM RECORDING`. Exit code 0: equal, 1: different, 3: no recording.
template <class Graph>
int run(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: %s RECORDING\n", argv[0]);
    return 2;
  }
  auto recording = read_recording(argv[1]);
  if (!recording) return 3;
  Checker checker(std::move(*recording));
  using Program = typename Graph::template Program<CheckingTrace<Graph>>;
  const auto program = std::make_unique<Program>();
  program->trace.checker = &checker;
  for (std::uint32_t episode = 0; episode < checker.recording().episodes.size(); ++episode) {
    program->trace.episode(episode);
    run_episode<Graph>(*program, checker, checker.recording().episodes[episode]);
  }
  checker.report();
  return 0;
}

}  // namespace eagerx::conformance
