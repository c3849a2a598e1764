#include "targets/environments/client/description.hpp"

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

#include "targets/environments/client/problem.hpp"

namespace eagerx::client {
namespace {

using nlohmann::json;

/// Bounds for each of `size` numbers; null is infinite.
std::vector<double> bounds(const json& space, const char* key, double infinite, std::size_t size) {
  std::vector<double> result(size, infinite);
  const auto found = space.find(key);
  if (found == space.end() || !found->is_array() || found->empty()) return result;
  for (std::size_t i = 0; i < size; ++i) {
    const json& bound = (*found)[i % found->size()];
    if (bound.is_number()) result[i] = bound.get<double>();
  }
  return result;
}

std::vector<Space> spaces(const json& list) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  std::vector<Space> result;
  for (const json& one : list) {
    Space space{one.at("name"), one.at("dtype"), 1, {}, {}, one.at("shape").empty()};
    for (const json& length : one.at("shape")) space.size *= length.get<std::size_t>();
    space.low = bounds(one, "low", -kInfinity, space.size);
    space.high = bounds(one, "high", kInfinity, space.size);
    result.push_back(std::move(space));
  }
  return result;
}

std::size_t numbers(const std::vector<Space>& spaces) {
  std::size_t sum = 0;
  for (const Space& space : spaces) sum += space.size;
  return sum;
}

std::vector<Stage> stages(const json& list) {
  constexpr double kNothing = -std::numeric_limits<double>::infinity();
  std::vector<Stage> result;
  for (const json& one : list) {
    const auto limit = [&](const char* key) {
      return one.at(key).is_number() ? one.at(key).get<double>() : kNothing;
    };
    result.push_back({one.at("name"), limit("success"), limit("return")});
  }
  return result;
}

}  // namespace

std::size_t Description::observation_numbers() const {
  return numbers(observations);
}
std::size_t Description::action_numbers() const {
  return numbers(actions);
}
std::size_t Description::critic_numbers() const {
  return numbers(critic);
}
bool Space::is_whole() const {
  return dtype.starts_with("int") || dtype.starts_with("uint");
}
bool Description::chooses() const {
  return !actions.empty() && std::ranges::all_of(actions, &Space::is_whole);
}

std::vector<std::string> column_names(const std::vector<Space>& states) {
  std::vector<std::string> names;
  for (const Space& state : states) {
    for (std::size_t i = 0; i < state.size; ++i)
      names.push_back(state.is_scalar ? state.name : state.name + "[" + std::to_string(i) + "]");
  }
  return names;
}

Description read_description(std::string_view text) {
  try {
    const json all = json::parse(text);
    Description result;
    result.graph = all.at("graph");
    result.hash = all.at("hash");
    result.program = all.value("program", "");
    result.rate_hz = all.at("rate_hz");
    result.has_threads = all.value("threads", true);
    result.observations = spaces(all.at("observations"));
    result.actions = spaces(all.at("actions"));
    result.states = spaces(all.at("states"));
    result.agent = all.value("agent", "");
    const json& task = all.at("task");
    if (!task.is_object()) return result;
    result.has_task = true;
    result.terms = task.at("terms").get<std::vector<std::string>>();
    result.has_success = task.at("success");
    result.episode_steps = task.at("episode_steps");
    if (task.contains("stages")) result.stages = stages(task.at("stages"));
    if (task.contains("critic")) result.critic = spaces(task.at("critic"));
    return result;
  } catch (const json::exception& error) {
    throw Problem(kInputOutput,
                  std::string("the library describes itself in an unknown way: ") + error.what(),
                  "build it again with this version of eagerx-gen");
  }
}

}  // namespace eagerx::client
