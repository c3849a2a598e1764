#include "targets/environments/client/description.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <runtime/host/base/json_reader.hpp>

#include "targets/environments/client/problem.hpp"

namespace eagerx::client {
namespace {

using Value = host::JsonValue;
using Kind = Value::Kind;

[[noreturn]] void not_understood(const std::string& what) {
  throw Problem(kInputOutput, "the library describes itself in an unknown way: " + what,
                "build it again with this version of eagerx-gen");
}

/// A member of an object.
const Value& described(const Value& of, const char* name, Kind kind) {
  const Value* const found = of.find(name);
  if (found == nullptr || !found->is(kind))
    not_understood(std::string("`") + name + "` is missing or of another type");
  return *found;
}
const std::string& text(const Value& of, const char* name) {
  return described(of, name, Kind::text).text;
}
double number(const Value& of, const char* name) {
  return described(of, name, Kind::number).number;
}
bool flag(const Value& of, const char* name) {
  return described(of, name, Kind::boolean).boolean;
}
const std::vector<Value>& list(const Value& of, const char* name) {
  return described(of, name, Kind::array).items;
}
std::size_t whole(double number) {
  constexpr double kEnd = 9007199254740992.0;  // 2^53
  if (number < 0.0 || number >= kEnd || number != std::floor(number))
    not_understood("a length or a count is not a whole number");
  return static_cast<std::size_t>(number);
}
std::vector<std::string> texts(const Value& of, const char* name) {
  std::vector<std::string> result;
  for (const Value& each : list(of, name)) {
    if (!each.is(Kind::text))
      not_understood(std::string("`") + name + "` has something that is not text");
    result.push_back(each.text);
  }
  return result;
}

/// Bounds for each of `size` numbers; null is infinite.
std::vector<double> bounds(const Value& space, const char* key, double infinite, std::size_t size) {
  std::vector<double> result(size, infinite);
  const Value* const found = space.find(key);
  if (found == nullptr || !found->is(Kind::array) || found->items.empty()) return result;
  for (std::size_t i = 0; i < size; ++i) {
    const Value& bound = found->items[i % found->items.size()];
    if (bound.is(Kind::number)) result[i] = bound.number;
  }
  return result;
}

std::vector<Space> spaces(const Value& of, const char* name) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  std::vector<Space> result;
  for (const Value& one : list(of, name)) {
    const std::vector<Value>& shape = list(one, "shape");
    Space space{text(one, "name"), text(one, "dtype"), 1, {}, {}, shape.empty()};
    for (const Value& length : shape) {
      if (!length.is(Kind::number)) not_understood("`shape` has something that is not a number");
      space.size *= whole(length.number);
    }
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

std::vector<Stage> stages(const Value& task) {
  constexpr double kNothing = -std::numeric_limits<double>::infinity();
  std::vector<Stage> result;
  for (const Value& one : list(task, "stages")) {
    const auto limit = [&](const char* key) {
      const Value* const found = one.find(key);
      return found != nullptr && found->is(Kind::number) ? found->number : kNothing;
    };
    result.push_back({text(one, "name"), limit("success"), limit("return")});
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

Description read_description(std::string_view description) {
  constexpr std::size_t kMostValues = 50'000'000;  // two bounds for each number of an image
  const auto read = host::read_json(description, kMostValues);
  if (!read) not_understood("it is not JSON");
  const Value& all = *read;
  Description result;
  result.graph = text(all, "graph");
  result.hash = text(all, "hash");
  if (all.find("program") != nullptr) result.program = text(all, "program");
  result.rate_hz = number(all, "rate_hz");
  result.has_threads = all.find("threads") == nullptr || flag(all, "threads");
  result.observations = spaces(all, "observations");
  result.actions = spaces(all, "actions");
  result.states = spaces(all, "states");
  if (all.find("agent") != nullptr) result.agent = text(all, "agent");
  const Value* const task = all.find("task");
  if (task == nullptr) not_understood("`task` is missing");
  if (!task->is(Kind::object)) return result;
  result.has_task = true;
  result.terms = texts(*task, "terms");
  result.has_success = flag(*task, "success");
  result.episode_steps = static_cast<std::uint32_t>(whole(number(*task, "episode_steps")));
  if (task->find("stages") != nullptr) result.stages = stages(*task);
  if (task->find("critic") != nullptr) result.critic = spaces(*task, "critic");
  return result;
}

}  // namespace eagerx::client
