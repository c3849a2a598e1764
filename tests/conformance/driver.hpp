// Runs a generated program with states and actions from standard input and prints everything that
// it shows of itself. The words of both are in README.md.
#pragma once

#include <cinttypes>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <eagerx/message.hpp>
#include <eagerx/rate.hpp>
#include <eagerx/trace.hpp>
#include <map>
#include <memory>
#include <string>
#include <type_traits>
#include <vector>

namespace eagerx::conformance {

/// A line of the script, cut into words.
class Line {
 public:
  /// False at the end.
  bool read();
  bool begins_with(const char* word) const;
  /// The name after the first word; `/` is written `_` in C++.
  bool names(const char* field) const;
  std::size_t values() const;
  const char* value(std::size_t i) const;
  const char* text() const;
  /// Whether both are `object/node/state` with the same object and state.
  bool names_state_of_node(const char* field) const;

 private:
  static constexpr std::size_t kMost = 1U << 16U;
  char text_[kMost]{};
  const char* words_[kMost / 2]{};
  std::size_t count_ = 0;
};

/// Ends the program: the script does not fit it.
[[noreturn]] void refuse(const char* what, const char* name);

inline void print(bool value) {
  std::printf(" %d", value ? 1 : 0);
}
inline void print(double value) {
  std::printf(" %#.17g", value);
}
inline void print(std::int64_t value) {
  std::printf(" %" PRId64, value);
}

template <class Message>
void print_message(const Message& message) {
  using Scalar = ScalarOf<Message>;
  using Printed = std::conditional_t<std::is_floating_point_v<Scalar>, double, std::int64_t>;
  for (std::size_t i = 0; i < size_of<Message>; ++i) {
    print(static_cast<Printed>(element(message, i)));
  }
}

template <class Message>
void assign(Message& message, const Line& line) {
  using Scalar = ScalarOf<Message>;
  if (line.values() != size_of<Message>) refuse("a number of values of", line.text());
  for (std::size_t i = 0; i < size_of<Message>; ++i) {
    if constexpr (std::is_floating_point_v<Scalar>) {
      element(message, i) = static_cast<Scalar>(std::strtod(line.value(i), nullptr));
    } else {
      element(message, i) = static_cast<Scalar>(std::strtoll(line.value(i), nullptr, 10));
    }
  }
}

template <class Window>
void print_window(const char* name, const Window& window) {
  std::printf("window %s %u", name, window.size());
  for (std::uint32_t i = 0; i < window.size(); ++i) std::printf(" %" PRIu64, window.seq(i));
  for (std::uint32_t i = 0; i < window.size(); ++i) print(window.template sent_s<double>(i));
  for (std::uint32_t i = 0; i < window.size(); ++i) print_message(window[i]);
  std::printf("\n");
}

/// Prints what callbacks get, what is sent, and the objects.
template <class Graph>
struct PrintingHooks {
  static constexpr bool kSeesInputs = true;
  static constexpr bool kSeesSimulators = true;

  HashTrace hash;
  std::map<std::string, std::vector<double>> begin_in;  // states of objects at the engine's tick 0

  template <class Message>
  void on_message(std::uint32_t channel, Seq seq, const Message& message) {
    hash.on_message(channel, seq, message);
    std::printf("sent %s %" PRIu64, Graph::kChannels[channel].name, seq);
    print_message(message);
    std::printf("\n");
  }

  template <class NodeRate, class Inputs>
  void on_inputs(const char* node, NodeRate /*rate*/, Seq tick, const Inputs& inputs) {
    std::printf("tick %s %" PRIu64 " %.17g\n", node, tick,
                NodeRate::template seconds<double>(tick));
    inputs.for_each([](const char* name, const auto& window) {
      if constexpr (requires { window.unpadded(); }) {
        print_window(name, window.unpadded());
      } else {
        print_window(name, window);
      }
    });
  }

  void on_reset_phase(bool begins) { std::printf("phase %d\n", begins ? 1 : 0); }

  template <class Simulator>
  void on_simulator(const char* object, Seq tick, Simulator& simulator) {
    const auto begin = begin_in.find(object);
    if constexpr (requires { simulator.state; }) {
      if (tick == 0 && begin != begin_in.end()) set_elements(simulator.state, begin->second);
    }
    std::printf("input %s %" PRIu64, object, tick);
    if constexpr (requires { simulator.input(); }) {
      print_message(simulator.input());
    } else if constexpr (requires { simulator.input; }) {
      print_elements(simulator.input);
    }
    std::printf("\nstate %s %" PRIu64, object, tick);
    if constexpr (requires { simulator.state; }) print_elements(simulator.state);
    std::printf("\n");
  }

 private:
  template <class Values>
  static void set_elements(Values& values, const std::vector<double>& wanted) {
    if constexpr (requires { values.begin(); }) {
      auto value = wanted.begin();
      for (auto& element : values) {
        if (value == wanted.end()) refuse("an object with so few values", "state");
        element = static_cast<std::remove_reference_t<decltype(element)>>(*value++);
      }
    } else {
      values = static_cast<Values>(wanted.at(0));
    }
  }
  template <class Values>
  static void print_elements(const Values& values) {
    if constexpr (requires { values.begin(); }) {
      for (const auto& value : values) print_message(value);
    } else {
      print_message(values);
    }
  }
};

template <class Observation>
void print_observation(const Observation& observation) {
  std::printf("observation\n");
  observation.for_each([](const char* name, const auto& window) {
    std::printf("seen %s", name);
    for (std::uint32_t i = 0; i < window.size(); ++i) print_message(window[i]);
    std::printf("\n");
  });
}

template <class States>
void set_state(States& states, const Line& line) {
  bool found = false;
  states.for_each([&](const char* name, auto& state) {
    if (!line.names(name)) return;
    found = true;
    state.emplace();
    assign(*state, line);
  });
  int same = 0;  // states of engine nodes, which may have other names than in EAGERx
  states.for_each([&](const char* name, auto& state) {
    if (found || !line.names_state_of_node(name)) return;
    ++same;
    state.emplace();
    assign(*state, line);
  });
  if (!found && same != 1) refuse("state", line.text());
}

template <class Graph>
void set_action(typename Graph::Action& action, const Line& line) {
  bool found = false;
  Graph::for_each_action(action, [&](const char* name, auto& message, const auto& /*space*/) {
    if (!line.names(name)) return;
    found = true;
    assign(message, line);
  });
  if (!found) refuse("action", line.text());
}

/// The main function.
template <class Graph>
int run() {
  const auto line = std::make_unique<Line>();
  const auto program = std::make_unique<typename Graph::template Program<PrintingHooks<Graph>>>();
  typename Graph::States states{};
  typename Graph::Action action{};
  while (line->read()) {
    if (line->begins_with("state")) {
      set_state(states, *line);
    } else if (line->begins_with("action")) {
      set_action<Graph>(action, *line);
    } else if (line->begins_with("object")) {
      std::vector<double>& values = program->hooks.begin_in[line->text()];
      for (std::size_t i = 0; i < line->values(); ++i)
        values.push_back(std::strtod(line->value(i), nullptr));
    } else if (line->begins_with("reset")) {
      std::printf("reset\n");
      print_observation(program->reset(states));
      states = {};
      program->hooks.begin_in.clear();
    } else if (line->begins_with("step")) {
      print_observation(program->step(action));
    } else {
      refuse("command", line->text());
    }
  }
  std::printf("hash %016" PRIx64 "\n", program->hooks.hash.hash());
  return 0;
}

}  // namespace eagerx::conformance
