// The table of `--csv`: one row per step, the same columns on every target.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/message.hpp>
#include <eagerx/rate.hpp>
#include <string_view>
#include <targets/common/run.hpp>

namespace eagerx::target {

/// Columns: `episode,step,time_s`, every element of every observation, every element of every
/// action. A column is named `name` (a scalar), `name[i]` (element i, flat, row-major), or
/// `name[w]` or `name[w][i]` if the observation has a window of more than one message (0 is the
/// oldest). Row 0 of an episode is the observation of the reset, without actions; row k has action
/// k and the observation that followed it. An observation with window 0 has columns for the maximum
/// number of messages; the last columns are empty if it has fewer. After the actions, a graph with
/// a task has columns for its results: `task.reward` and so on. `Writer` has text(std::string_view)
/// and number(value).
template <class Graph, class Writer>
class CsvTable {
 public:
  using Action = typename Graph::Action;
  using Observation = typename Graph::Observation;
  using Outcome = typename OutcomeOf<Graph>::Type;

  struct NoMore {
    void operator()(Writer& /*out*/) const {}
  };

  /// `more(out)` writes the names of further columns, each after a comma; in row(), their values.
  template <class More = NoMore>
  static void header(Writer& out, const Observation& observation, const More& more = {}) {
    out.text("episode,step,time_s");
    Graph::for_each_observation(
        observation, [&](const char* name, const auto& window, const auto&... /*space*/) {
          using Message = typename std::remove_cvref_t<decltype(window)>::value_type;
          const std::uint32_t columns = columns_of(window);
          for (std::uint32_t w = 0; w < columns; ++w) {
            column_names(out, name, columns > 1, w, Message{});
          }
        });
    Action action = Graph::zero();
    Graph::for_each_action(action, [&](const char* name, const auto& message, const auto&...) {
      column_names(out, name, false, 0, message);
    });
    Outcome{}.for_each([&](const char* name, auto /*value*/) {
      out.text(",task.");
      out.text(name);
    });
    more(out);
    out.text("\n");
  }

  /// `action` and `outcome` are null for the row of a reset.
  template <class More = NoMore>
  static void row(Writer& out, std::uint32_t episode, Seq step, const Observation& observation,
                  const Action* action, const Outcome* outcome, const More& more = {}) {
    out.number(episode);
    out.text(",");
    out.number(step);
    out.text(",");
    out.number(Graph::Rate::template seconds<double>(step));
    Graph::for_each_observation(observation, [&](const char*, const auto& window, const auto&...) {
      using Message = typename std::remove_cvref_t<decltype(window)>::value_type;
      for (std::uint32_t w = 0; w < window.size(); ++w) elements(out, window[w]);
      const std::uint32_t missing = columns_of(window) - window.size();
      for (std::size_t i = 0; i < missing * size_of<Message>; ++i) out.text(",");
    });
    action != nullptr ? action_elements(out, *action) : no_action_elements(out);
    (outcome != nullptr ? *outcome : Outcome{}).for_each([&](const char*, auto value) {
      out.text(",");
      if (outcome != nullptr) out.number(value);
    });
    more(out);
    out.text("\n");
  }

 private:
  /// Messages that the table has columns for: all that there can be. With window 0 a row may have
  /// fewer.
  template <class Observed>
  static std::uint32_t columns_of(const Observed& window) {
    if constexpr (requires { Observed::kMaxSize; }) {
      return Observed::kMaxSize;
    } else {
      return window.size();
    }
  }

  template <class Message>
  static void column_names(Writer& out, const char* name, bool windowed, std::uint32_t w,
                           const Message& /*message*/) {
    for (std::size_t i = 0; i < size_of<Message>; ++i) {
      out.text(",");
      out.text(name);
      if (windowed) index(out, w);
      if constexpr (!std::is_arithmetic_v<Message>) index(out, static_cast<std::uint32_t>(i));
    }
  }

  static void index(Writer& out, std::uint32_t i) {
    out.text("[");
    out.number(i);
    out.text("]");
  }

  template <class Message>
  static void elements(Writer& out, const Message& message) {
    for (std::size_t i = 0; i < size_of<Message>; ++i) {
      out.text(",");
      out.number(element(message, i));
    }
  }

  static void action_elements(Writer& out, Action action) {
    Graph::for_each_action(
        action, [&](const char*, const auto& message, const auto&...) { elements(out, message); });
  }

  static void no_action_elements(Writer& out) {
    Action action = Graph::zero();
    Graph::for_each_action(action, [&](const char*, const auto& message, const auto&...) {
      for (std::size_t i = 0; i < size_of<std::remove_cvref_t<decltype(message)>>; ++i) {
        out.text(",");
      }
    });
  }
};

}  // namespace eagerx::target
