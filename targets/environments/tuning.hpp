// What may be set while an episode runs.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <runtime/host/base/json.hpp>
#include <string>
#include <targets/common/run.hpp>
#include <targets/environments/layout.hpp>
#include <targets/environments/problem.hpp>

namespace eagerx::environments {

/// f(name) for each state of the graph that an episode can change.
template <class Graph, class F>
void for_each_tunable(F&& f) {
  std::size_t i = 0;
  Graph::for_each_state([&](const char* name, const char*, auto, const auto&) {
    if (target::is_tunable<Graph>(i++)) f(name);
  });
}

template <class Graph>
std::string describe_tunable() {
  host::Json json;
  json.begin_list();
  for_each_tunable<Graph>([&](const char* name) { json.text(name); });
  return json.end_list().str();
}

/// What is wrong with a row of states [numbers] of which those that are not NaN are set while an
/// episode runs, or nothing.
template <class Graph>
std::string problem_of_tuning(const float* row) {
  const Layout<Graph>& layout = Layout<Graph>::get();
  std::string problem = layout.problem_of(row);
  std::size_t field = 0;
  Graph::for_each_state([&](const char* name, const char*, auto, const auto& space) {
    constexpr std::size_t kSize = size_of<std::remove_cvref_t<decltype(space.low)>>;
    const std::size_t i = field++;
    const float* const from = row + layout.states.first(i);
    std::size_t given = 0;
    for (std::size_t k = 0; k < kSize; ++k) given += std::isnan(from[k]) ? 0 : 1;
    if (given == 0 || !problem.empty()) return;
    const std::string quoted = "`" + std::string(name) + "`";
    if (!target::is_tunable<Graph>(i)) {
      std::string list;
      for_each_tunable<Graph>(
          [&](const char* each) { list += (list.empty() ? "" : ", ") + std::string(each); });
      problem = quoted + " can be set at a reset, not while an episode runs; what can: " +
                (list.empty() ? "nothing of this graph" : list);
    } else if (given != kSize) {
      problem = quoted + ": set all of its elements, or none";
    }
  });
  return problem;
}

/// Throws Problem for rows [environments][numbers] of which one that is meant is wrong.
template <class Graph>
void check_tuning(std::uint32_t environments, const std::uint8_t* mask, const float* states) {
  const std::size_t numbers = Layout<Graph>::get().states.numbers();
  for (std::uint32_t k = 0; k < environments; ++k) {
    if (mask != nullptr && mask[k] == 0) continue;
    const std::string problem = problem_of_tuning<Graph>(states + k * numbers);
    if (!problem.empty()) throw Problem(problem + " (environment " + std::to_string(k) + ")");
  }
}

template <class Graph>
typename Graph::States tuned_states(const float* row) {
  typename Graph::States states{};
  Layout<Graph>::get().read(row, states);
  return states;
}

}  // namespace eagerx::environments
