// Converts between the types of a graph and the rows of the linux-sim library.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <eagerx/message.hpp>
#include <eagerx/space.hpp>
#include <memory>
#include <targets/common/run.hpp>
#include <targets/linux-sim/graph_program.hpp>
#include <type_traits>

namespace eagerx::linux_sim {

template <class Graph>
void copy_states(const typename Graph::States& states, StateRow row) {
  std::size_t i = 0;
  Graph::for_each_state([&](const char*, const char*, auto member, const auto&) {
    row.has_value[i] = (states.*member).has_value();
    if (row.has_value[i])
      std::memcpy(row.messages[i], &*(states.*member), sizeof *(states.*member));
    ++i;
  });
}
template <class Graph>
void take_states(StateRow row, typename Graph::States& states) {
  std::size_t i = 0;
  Graph::for_each_state([&](const char*, const char*, auto member, const auto&) {
    if (row.has_value[i]) {
      if (!(states.*member)) (states.*member).emplace();
      std::memcpy(&*(states.*member), row.messages[i], sizeof *(states.*member));
    }
    ++i;
  });
}

template <class Graph>
void copy_observation(const typename Graph::Observation& observation, ObservationRow row) {
  std::size_t i = 0;
  Graph::for_each_observation(observation, [&](const char*, const auto& window, const auto&...) {
    using Message = typename std::remove_cvref_t<decltype(window)>::value_type;
    auto* const messages = static_cast<Message*>(row.messages[i]);
    row.sizes[i] = window.size();
    for (std::uint32_t w = 0; w < window.size(); ++w) messages[w] = window[w];
    ++i;
  });
}
/// Makes the windows of `observation` show the messages of `row`.
template <class Graph>
void show_row(ObservationRow row, typename Graph::Observation& observation) {
  std::size_t i = 0;
  Graph::for_each_observation(observation, [&](const char*, const auto& window, const auto&...) {
    using Window = std::remove_cvref_t<decltype(window)>;
    const auto* const messages = static_cast<const typename Window::value_type*>(row.messages[i]);
    // `observation` is not a constant, only what for_each_observation() shows of it.
    std::construct_at(const_cast<Window*>(&window), messages, Seq{row.sizes[i]});
    ++i;
  });
}

template <class Message>
Field field_of(const char* name, const Space<Message>& space) {
  return {name, TypeOf<Message>::value, &space.low, &space.high};
}
template <class Message>
Field field_of(const char* name) {
  return {name, TypeOf<Message>::value};
}

/// Messages of an observation that there can be.
template <class Window>
constexpr std::uint32_t most_of() {
  if constexpr (requires { Window::kMaxSize; }) {
    return Window::kMaxSize;
  } else {
    return Window::size();
  }
}

template <class Graph>
void list_actions(FieldListener& listener) {
  typename Graph::Action action = Graph::zero();
  const auto* const begin = reinterpret_cast<const std::byte*>(&action);
  Graph::for_each_action(action, [&](const char* name, auto& message, const auto&... space) {
    Field field = field_of<std::remove_cvref_t<decltype(message)>>(name, space...);
    field.offset = static_cast<std::size_t>(reinterpret_cast<const std::byte*>(&message) - begin);
    listener.action(field);
  });
}

template <class Graph>
void list_observations(FieldListener& listener) {
  // Its windows are not read.
  using Observation = typename Graph::Observation;
  static_assert(std::is_trivially_copyable_v<Observation>);
  const auto any = std::bit_cast<Observation>(std::array<std::byte, sizeof(Observation)>{});
  Graph::for_each_observation(any, [&](const char* name, const auto& window, const auto&... space) {
    using Window = std::remove_cvref_t<decltype(window)>;
    Field field = field_of<typename Window::value_type>(name, space...);
    field.most = most_of<Window>();
    if constexpr (requires { Window::kAlwaysFull; }) field.varies = !Window::kAlwaysFull;
    listener.observation(field);
  });
}

template <class Graph>
void list_states(FieldListener& listener) {
  std::size_t i = 0;
  Graph::for_each_state([&](const char* name, const char* id, auto /*member*/, const auto& space) {
    Field field = field_of(name, space);
    field.id = id;
    field.tunable = target::is_tunable<Graph>(i++);
    listener.state(field);
  });
  Graph::for_each_range([&](const char* name, auto /*member*/, const auto& space) {
    listener.range(field_of(name, space));
  });
}

template <class Graph>
void list_outcomes(FieldListener& listener) {
  typename target::OutcomeOf<Graph>::Type{}.for_each([&](const char* name, auto value) {
    listener.outcome(name, std::is_same_v<decltype(value), bool>);
  });
}

template <class Outcome>
OutcomeView view_of_outcome(const Outcome& outcome) {
  if constexpr (requires { Outcome::kTerms; }) {
    return {static_cast<double>(outcome.reward),
            outcome.terminated,
            outcome.truncated,
            outcome.success,
            &outcome.terms[0],
            scalar_of<std::remove_cvref_t<decltype(outcome.terms[0])>>()};
  } else {
    return {};
  }
}

}  // namespace eagerx::linux_sim
