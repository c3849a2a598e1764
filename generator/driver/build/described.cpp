#include "generator/driver/build/described.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>
#include <vector>

#include "generator/support/diagnostics/search.hpp"
#include "generator/support/json/json.hpp"

namespace eagerx::gen {
namespace {

/// As the library says it: of float32 the shortest decimal that reads back to it.
Json bound_of(Dtype dtype, double bound) {
  if (!std::isfinite(bound)) return nullptr;
  if (dtype != Dtype::float32) return bound;
  return std::strtod(fmt::format("{}", static_cast<float>(bound)).c_str(), nullptr);
}

Json bounds(Dtype dtype, const std::vector<double>& of_elements) {
  Json list = Json::list();
  for (const double bound : of_elements) list.push_back(bound_of(dtype, bound));
  return list;
}

/// As rows have them: in the order of names.
class Spaces {
 public:
  void add(std::string name, const Space& space, std::uint32_t window = 1) {
    Json shape = Json::list();
    if (window > 1) shape.push_back(window);
    for (const auto length : space.shape) shape.push_back(length);
    spaces_.emplace_back(std::move(name), Json{{"shape", std::move(shape)},
                                               {"dtype", std::string(to_string(space.dtype))},
                                               {"low", bounds(space.dtype, space.low)},
                                               {"high", bounds(space.dtype, space.high)}});
    spaces_.back().second["name"] = spaces_.back().first;
  }
  Json list() {
    std::ranges::sort(spaces_, {}, [](const auto& one) -> const std::string& { return one.first; });
    Json result = Json::list();
    for (auto& [name, space] : spaces_) result.push_back(std::move(space));
    return result;
  }

 private:
  std::vector<std::pair<std::string, Json>> spaces_;
};

/// Those that a program's States has, and delays that it can be given.
Json states_of(const Graph& graph) {
  Spaces states;
  for (const Object& object : graph.objects) {
    for (const State& state : object.states)
      states.add(object.name + "." + state.name, state.space);
  }
  for (const GraphNode& node : graph.nodes) {
    for (const State& state : node.states) {
      if (state.settable) states.add(node.name + "." + state.name, state.space);
    }
    for (const Input& input : node.inputs) {
      if (!input.max_delay_s || (input.entity_sets_delay && !input.random_delay)) continue;
      states.add(node.name + "." + input.name + "/delay",
                 {Dtype::float64, {}, {0.0}, {input.max_delay_s->to_double()}});
    }
  }
  return states.list();
}

}  // namespace

std::string description_of(const Graph& graph) {
  const GraphNode& environment = graph.environment();
  const auto is_unlimited = [](const Input& input) { return input.window == 0; };
  if (ranges::any_of(environment.inputs, is_unlimited)) return {};
  Spaces observations, actions;
  for (const Input& input : environment.inputs)
    observations.add(input.name, input.space, input.window);
  for (const Output& output : environment.outputs) actions.add(output.name, output.space);
  Json task;
  if (graph.task) {
    task = Json{{"terms", Json::list()},
                {"success", !graph.task->success.empty()},
                {"episode_steps", graph.task->after}};
  }
  return dump_json(Json{{"graph", graph.name},
                        {"hash", ""},
                        {"rate_hz", environment.rate_hz.to_double()},
                        {"observations", observations.list()},
                        {"actions", actions.list()},
                        {"states", states_of(graph)},
                        {"task", std::move(task)}});
}

}  // namespace eagerx::gen
