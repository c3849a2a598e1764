// The states that a reset sets, in numbers with derivatives.
#pragma once

#include <cstddef>
#include <cstdio>
#include <eagerx/math.hpp>
#include <eagerx/message.hpp>
#include <eagerx/number.hpp>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace eagerx::linearize {

/// The states of the program for plain numbers, in numbers with derivatives.
template <class States, class PlainStates>
States with_derivatives(PlainStates plain) {
  std::vector<std::optional<std::vector<long double>>> values;
  plain.for_each([&](const char*, const auto& message) {
    auto& value = values.emplace_back();
    if (!message) return;
    value.emplace();
    for (std::size_t i = 0; i < size_of<std::remove_reference_t<decltype(*message)>>; ++i)
      value->push_back(static_cast<long double>(element(*message, i)));
  });
  States states;
  std::size_t next = 0;
  states.for_each([&](const char*, auto& message) {
    const auto& value = values[next++];
    if (!value) return;
    auto& set = message.emplace();
    using Scalar = ScalarOf<std::remove_reference_t<decltype(set)>>;
    using Plain = std::conditional_t<std::is_same_v<Scalar, Number>, double, Scalar>;
    for (std::size_t i = 0; i < value->size(); ++i)
      element(set, i) = Scalar(static_cast<Plain>((*value)[i]));
  });
  return states;
}

/// Numbers of all states that a reset sets.
template <class States>
std::size_t count_elements(States& states) {
  std::size_t count = 0;
  states.for_each([&](const char*, const auto& message) {
    if (message) count += size_of<std::remove_cvref_t<decltype(*message)>>;
  });
  return count;
}

/// Gives those from `first` on a derivative of 1, each in its own.
template <class States>
void seed_elements(States& states, std::size_t first) {
  std::size_t at = 0;
  states.for_each([&](const char*, auto& message) {
    if (!message) return;
    using Message = std::remove_cvref_t<decltype(*message)>;
    for (std::size_t i = 0; i < size_of<Message>; ++i, ++at) {
      if constexpr (std::is_same_v<ScalarOf<Message>, Number>) {
        if (at >= first && at < first + kSeeds) element(*message, i).derivative[at - first] = 1.0;
      }
    }
  });
}

inline void print_number(const char* separator, double x) {
  if (eagerx::isfinite(x))
    std::printf("%s%.17g", separator, x);
  else
    std::printf("%snull", separator);
}

/// The range that element `i` of a state is sampled from; null if it is not.
template <class Graph>
void print_range(typename Graph::States& states, const void* state, std::size_t i) {
  bool is_sampled = false;
  Graph::for_each_range([&](const char*, auto member, const auto& space) {
    if (static_cast<const void*>(&(states.*member)) != state) return;
    is_sampled = true;
    print_number(", ", static_cast<double>(element(space.low, i)));
    print_number(", ", static_cast<double>(element(space.high, i)));
  });
  if (!is_sampled) std::printf(", null, null");
}

/// ["pendulum.model_state", element, value, low, high, sampled from, to] of each number, in the
/// order of States.
template <class Graph>
void print_states(typename Graph::States states) {
  std::printf(",\n\"states\": [");
  const char* separator = "\n";
  states.for_each([&](const char*, const auto& message) {
    if (!message) return;
    Graph::for_each_state([&](const char* name, const char*, auto member, const auto& space) {
      if (static_cast<const void*>(&(states.*member)) != static_cast<const void*>(&message)) return;
      if constexpr (std::is_same_v<std::remove_cvref_t<decltype(states.*member)>,
                                   std::remove_cvref_t<decltype(message)>>) {
        for (std::size_t i = 0; i < size_of<std::remove_cvref_t<decltype(*message)>>; ++i) {
          std::printf("%s[\"%s\", %zu", separator, name, i);
          print_number(", ", static_cast<double>(element(*message, i)));
          print_number(", ", static_cast<double>(element(space.low, i)));
          print_number(", ", static_cast<double>(element(space.high, i)));
          print_range<Graph>(states, &message, i);
          std::printf("]");
          separator = ",\n";
        }
      }
    });
  });
  std::printf("]");
}

}  // namespace eagerx::linearize
