#include <targets/environments/eagerx_environments.h>

#include <cstddef>
#include <cstdint>
#include <runtime/host/base/hash.hpp>
#include <runtime/host/base/json.hpp>
#include <span>
#include <string>
#include <targets/environments/base/description.hpp>
#include <targets/environments/base/problem.hpp>

namespace eagerx::environments {
namespace {

std::string name_of(UsedSimd simd) {
  return std::to_string(simd.lanes) + " lanes (" + simd.isa + ")";
}

}  // namespace

std::string describe(const Description& description) {
  host::Json json;
  json.begin_object().key("version").whole(EAGERX_ENVIRONMENTS_VERSION);
  json.key("generator").text(description.generator).key("graph").text(description.graph);
  json.key("engine").text(description.engine);
  json.key("rate_hz").number(description.rate_hz);
  const std::string contract = json.str() + description.observations + description.actions;
  json.key("hash").text(host::hex_text(host::fnv1a(contract)));
  json.key("program").text(host::hex_text(description.program));
  json.key("isa").text(description.isa);
  json.key("lanes").whole(description.lanes);
  if (description.why_no_lanes != nullptr) json.key("why_no_lanes").text(description.why_no_lanes);
  json.key("observations").written(description.observations);
  json.key("actions").written(description.actions).key("states").written(description.states);
  json.key("tunable").written(description.tunable).key("agent").text(description.agent);
  json.key("task").written(description.task).key("render").written(description.render);
  return json.end_object().str();
}

std::string describe_task(const TaskDescription& task) {
  host::Json json;
  json.begin_object().key("terms").begin_list();
  for (const char* name : task.terms) json.text(name);
  json.end_list().key("success").boolean(task.success);
  json.key("episode_steps").whole(task.episode_steps);
  json.key("critic").written(task.critic).key("stages").written(task.stages);
  return json.end_object().str();
}

std::string describe_stages(std::span<const char* const> names, std::span<const Until> until) {
  host::Json json;
  json.begin_list();
  for (std::size_t i = 0; i < names.size(); ++i) {
    json.begin_object().key("name").text(names[i]);
    json.key("success").number(until[i].success).key("return").number(until[i].mean_return);
    json.end_object();
  }
  return json.end_list().str();
}

std::string describe_render(double rate_hz) {
  host::Json json;
  return json.begin_object().key("rate_hz").number(rate_hz).end_object().str();
}

void refuse_stage(const std::string& name, std::span<const char* const> known) {
  std::string list;
  for (const char* each : known) list += (list.empty() ? "" : ", ") + std::string(each);
  refuse("there is no stage `" + name + "`, but " +
         (list.empty() ? "none: the task has no `stages:`" : list));
}

std::string stepping_text(UsedSimd used, UsedSimd widest, std::uint32_t environments, bool draws,
                          const std::string& graph_has_none) {
  const std::string one_by_one = "one by one: ";
  if (!graph_has_none.empty()) return one_by_one + graph_has_none;
  if (draws) return one_by_one + "their pictures are wanted";
  if (widest.lanes == 0) return one_by_one + "EAGERX_SIMD or this processor allows no SIMD lanes";
  const std::string few = std::to_string(environments) +
                          (environments == 1 ? " environment is" : " environments are") +
                          " too few for ";
  if (used.lanes == 0) return one_by_one + few + "SIMD lanes";
  const std::string simd = "vectorized: " + name_of(used);
  return used.lanes == widest.lanes ? simd : simd + "; " + few + name_of(widest);
}

void Counts::add_to(const char* name, std::uint64_t count) {
  sums_[name] += count;
}

std::string Counts::text() const {
  host::Json json;
  json.begin_object();
  for (const auto& [name, count] : sums_) json.key(name).whole(count);
  return json.end_object().str();
}

}  // namespace eagerx::environments
