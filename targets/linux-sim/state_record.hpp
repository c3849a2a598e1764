// The states and delays that the episodes of a run begin with, for table, trace and summary.
#pragma once

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <eagerx/message.hpp>
#include <limits>
#include <runtime/host/trace/log_file.hpp>
#include <string>
#include <targets/linux-sim/describe.hpp>
#include <targets/linux-sim/summary.hpp>
#include <type_traits>
#include <utility>
#include <vector>

namespace eagerx::linux_sim {

/// Nothing of it allocates but the constructor and describe().
template <class Graph>
class StateRecord {
 public:
  using States = typename Graph::States;

  StateRecord() {
    std::size_t elements = 0;
    for_each(
        [&](const auto&, const auto& state, const auto&) { elements += size_of_state(state); });
    least_.assign(elements, std::numeric_limits<double>::infinity());
    most_.assign(elements, -std::numeric_limits<double>::infinity());
  }

  /// An episode begins. What `states` does not have stays as it was.
  void begin(const States& states) {
    std::size_t at = 0;
    Graph::for_each_state([&](const char*, const char*, auto member, const auto&) {
      if (states.*member) current_.*member = states.*member;
      using Message = typename std::remove_cvref_t<decltype(current_.*member)>::value_type;
      for (std::size_t i = 0; i < size_of<Message>; ++i, ++at) {
        if (!(current_.*member)) continue;
        const auto x = static_cast<double>(element(*(current_.*member), i));
        least_[at] = std::min(least_[at], x);
        most_[at] = std::max(most_[at], x);
      }
    });
  }

  /// f(number of the state, message) for each that has a value.
  template <class F>
  void for_each_value(F&& f) const {
    std::uint32_t number = 0;
    for_each([&](const char*, const auto& state, const char*) {
      if (state) f(number, *state);
      ++number;
    });
  }

  /// Lines `# state EPISODE NAME VALUE,…`, which are no messages: the hash does not see them.
  template <class Writer>
  void trace(Writer& out, std::uint32_t episode) const {
    for_each([&](const char* /*name*/, const auto& state, const char* id) {
      if (!state) return;
      out.text("# state ");
      out.number(episode);
      out.text(" ");
      out.text(id);
      values(out, *state, " ");
      out.text("\n");
    });
  }

  template <class Writer>
  void column_names(Writer& out) const {
    for_each([&](const char* name, const auto& state, const auto&) {
      using Message = typename std::remove_cvref_t<decltype(state)>::value_type;
      for (std::size_t i = 0; i < size_of<Message>; ++i) {
        out.text(",state:");
        out.text(name);
        if constexpr (std::is_arithmetic_v<Message>) continue;
        out.text("[");
        out.number(i);
        out.text("]");
      }
    });
  }
  template <class Writer>
  void columns(Writer& out) const {
    for_each([&](const char* /*name*/, const auto& state, const auto&) {
      if (state) return values(out, *state, ",");
      for (std::size_t i = 0; i < size_of_state(state); ++i) out.text(",");
    });
  }

  /// A line for each state: its value, or from where to where it was drawn.
  void describe(Summary& summary) const {
    std::size_t at = 0;
    for_each([&](const char* name, const auto& state, const auto&) {
      const std::size_t size = size_of_state(state);
      const std::size_t first = std::exchange(at, at + size);
      if (!state) return;
      using Scalar = ScalarOf<typename std::remove_cvref_t<decltype(state)>::value_type>;
      std::string least, most;
      for (std::size_t i = first; i < at; ++i) {
        least += (i > first ? ", " : "") + text_of<Scalar>(least_[i]);
        most += (i > first ? ", " : "") + text_of<Scalar>(most_[i]);
      }
      if (size > 1) {
        least = "[" + least + "]";
        most = "[" + most + "]";
      }
      summary.states.emplace_back(name, least == most ? least : least + " to " + most);
    });
  }

 private:
  template <class F>
  void for_each(F&& f) const {
    Graph::for_each_state([&](const char* name, const char* id, auto member, const auto&) {
      f(name, current_.*member, id);
    });
  }
  template <class State>
  static constexpr std::size_t size_of_state(const State& /*state*/) {
    return size_of<typename State::value_type>;
  }
  template <class Scalar>
  static std::string text_of(double x) {
    if constexpr (std::is_same_v<Scalar, float>) return number_text(static_cast<float>(x));
    return number_text(x);
  }
  /// `before` comes before the first value, a comma before each other.
  template <class Writer, class Message>
  static void values(Writer& out, const Message& message, const char* before) {
    for (std::size_t i = 0; i < size_of<Message>; ++i) {
      out.text(i == 0 ? before : ",");
      out.number(element(message, i));
    }
  }

  States current_{};
  std::vector<double> least_, most_;  // of all elements
};

/// Puts what a log says of its episode's states into `states`.
template <class Graph>
void repeat_states(const trace_log::Log& log, std::uint32_t episode,
                   typename Graph::States& states) {
  for (const trace_log::RecordedState& recorded : log.states) {
    if (recorded.episode != episode) continue;
    Graph::for_each_state([&](const char* /*name*/, const char* id, auto member, const auto&) {
      using Message = typename std::remove_cvref_t<decltype(states.*member)>::value_type;
      if (recorded.name != id || recorded.values.size() != size_of<Message>) return;
      Message message{};
      for (std::size_t i = 0; i < size_of<Message>; ++i) {
        const std::string& text = recorded.values[i];
        ScalarOf<Message>& x = element(message, i);
        if constexpr (std::is_same_v<ScalarOf<Message>, bool>) {
          x = text == "1";
        } else if (std::from_chars(text.data(), text.data() + text.size(), x).ec != std::errc()) {
          return;
        }
      }
      states.*member = message;
    });
  }
}

}  // namespace eagerx::linux_sim
