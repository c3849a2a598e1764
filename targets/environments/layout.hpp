// Rows of numbers: which columns belong to which action, observation and state.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <eagerx/message.hpp>
#include <limits>
#include <optional>
#include <runtime/host/base/number.hpp>
#include <targets/common/from_number.hpp>
#include <targets/common/run.hpp>
#include <targets/environments/base/columns.hpp>
#include <targets/environments/base/state_rows.hpp>
#include <type_traits>
#include <vector>

namespace eagerx::environments {

/// Messages of an observation in a row: all that there can be.
template <class Observed>
constexpr std::uint32_t messages_of() {
  if constexpr (requires { Observed::kMaxSize; }) {
    return Observed::kMaxSize;
  } else {
    return Observed::size();
  }
}

/// Converts a number of a row to an element of a message.
template <class T>
T from_row(float x) {
  return target::from_number<T>(x);
}

/// Converts a number of a row of states to an element of a state.
template <class T>
T state_from_row(float x) {
  if constexpr (std::is_same_v<T, double>) return host::same_decimal(x);
  return from_row<T>(x);
}

/// Elements of a message, such as a bound of its space.
template <class Number, class Message>
std::vector<Number> elements_of(const Message& message) {
  std::vector<Number> elements(size_of<Message>);
  for (std::size_t i = 0; i < elements.size(); ++i)
    elements[i] = static_cast<Number>(element(message, i));
  return elements;
}

/// The rows of a graph.
template <class Graph>
class Layout {
 public:
  using Action = typename Graph::Action;
  using Observation = typename Graph::Observation;
  using States = typename Graph::States;

  Columns actions, observations;
  StateRows states;

  static const Layout& get() {
    static const Layout layout;
    return layout;
  }

  /// f(name, type of the observation's window, space) for each, in the graph's order.
  template <class F>
  static void for_each_observed(F&& f) {
    static_assert(std::is_trivially_copyable_v<Observation>);
    // Its windows are not read.
    const auto nothing = std::bit_cast<Observation>(std::array<std::byte, sizeof(Observation)>{});
    Graph::for_each_observation(nothing,
                                [&](const char* name, const auto& window, const auto& space) {
                                  using Observed = std::remove_cvref_t<decltype(window)>;
                                  f(name, std::type_identity<Observed>{}, space);
                                });
  }

  Action action(const float* row) const {
    Action result = Graph::zero();
    std::size_t field = 0;
    Graph::for_each_action(result, [&](const char*, auto& message, const auto&) {
      using Message = std::remove_cvref_t<decltype(message)>;
      // The only one begins the row: a step of one environment notices what it takes to ask.
      const float* const from =
          sizeof(Message) == sizeof(Action) ? row : row + actions.first(field++);
      for (std::size_t i = 0; i < size_of<Message>; ++i)
        element(message, i) = from_row<ScalarOf<Message>>(from[i]);
    });
    return result;
  }

  /// With window 0 there may be fewer messages than columns: the rest is NaN, or 0 for whole
  /// numbers.
  void write(const Observation& observation, float* row) const {
    std::size_t field = 0;
    Graph::for_each_observation(observation, [&](const char*, const auto& window, const auto&) {
      using Observed = std::remove_cvref_t<decltype(window)>;
      using Message = typename Observed::value_type;
      float* to = sizeof(Observed) == sizeof(Observation) ? row : row + observations.first(field++);
      for (std::uint32_t w = 0; w < window.size(); ++w) {
        const Message& message = window[w];
        for (std::size_t i = 0; i < size_of<Message>; ++i)
          *to++ = static_cast<float>(element(message, i));
      }
      constexpr auto kMissing = std::numeric_limits<ScalarOf<Message>>::quiet_NaN();
      const std::size_t missing = messages_of<Observed>() - window.size();
      std::fill_n(to, missing * size_of<Message>, static_cast<float>(kMissing));
    });
  }

  /// NaN for empty states.
  template <class Number>
  void write(const States& from, Number* row) const {
    std::size_t field = 0;
    Graph::for_each_state([&](const char*, const char*, auto member, const auto&) {
      using Message = typename std::remove_cvref_t<decltype(from.*member)>::value_type;
      Number* const to = row + states.columns.first(field++);
      for (std::size_t i = 0; i < size_of<Message>; ++i) {
        to[i] = from.*member ? static_cast<Number>(element(*(from.*member), i))
                             : std::numeric_limits<Number>::quiet_NaN();
      }
    });
  }

  /// Puts the numbers of a row that are not NaN into `to`.
  void read(const float* row, States& to) const {
    std::size_t field = 0;
    Graph::for_each_state([&](const char*, const char*, auto member, const auto&) {
      using Message = typename std::remove_cvref_t<decltype(to.*member)>::value_type;
      const float* const from = row + states.columns.first(field++);
      for (std::size_t i = 0; i < size_of<Message>; ++i) {
        if (std::isnan(from[i])) continue;
        if (!(to.*member)) to.*member = Message{};
        element(*(to.*member), i) = state_from_row<ScalarOf<Message>>(from[i]);
      }
    });
  }

 private:
  Layout() {
    Action action = Graph::zero();
    Graph::for_each_action(action, [&](const char* name, const auto& message, const auto&) {
      actions.add(name, size_of<std::remove_cvref_t<decltype(message)>>);
    });
    for_each_observed([&](const char* name, auto observed, const auto&) {
      using Observed = typename decltype(observed)::type;
      observations.add(name, messages_of<Observed>() * size_of<typename Observed::value_type>);
    });
    const States sampled = Graph::sample({0, 0, 0});  // the same states for every key
    std::size_t i = 0;
    Graph::for_each_state([&](const char* name, const char*, auto member, const auto& space) {
      const bool is_sampled = (sampled.*member).has_value();
      states.add({name, elements_of<float>(space.low), elements_of<float>(space.high), is_sampled,
                  target::is_tunable<Graph>(i++)});
    });
    actions.arrange();
    observations.arrange();
    states.arrange();
  }
};

}  // namespace eagerx::environments
