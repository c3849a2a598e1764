#include "generator/support/json/json.hpp"

#include "generator/analysis/info/info.hpp"
#include "generator/graph/plan/vectorized.hpp"

namespace eagerx::gen {
namespace {

Json json_of(const std::vector<AgeEdge>& path) {
  Json json = Json::list();
  for (const auto& edge : path)
    json.push_back(Json{{"input", edge.input}, {"newest", time_json(edge.newest_s)}});
  return json;
}

Json json_of(const DataAge& age) {
  Json json = {{"sensor", age.from}, {"actuator", age.to}, {"newest", time_json(age.newest_s)}};
  json["oldest"] = age.oldest_s ? time_json(*age.oldest_s) : Json(nullptr);
  json["reached"] = age.exact;
  json["way"] = json_of(age.path);
  return json;
}

Json json_of(const DataAge& age, const AgeLimit& limit) {
  Json json = {{"from", age.from}, {"to", age.to}, {"newest", time_json(age.newest_s)}};
  json["oldest"] = age.oldest_s ? time_json(*age.oldest_s) : Json(nullptr);
  json["reached"] = age.exact;
  json["at_most"] = time_json(limit.at_most_s);
  json["kept"] = age.newest_s <= limit.at_most_s;
  json["agent"] = limit.ends.through_agent || limit.ends.from_actions;
  json["way"] = json_of(age.path);
  return json;
}

Json json_of(const LinkLoad& load) {
  return {{"frames_per_s", load.frames_per_s.to_double()},
          {"bytes_per_s", load.bytes_per_s.to_double()},
          {"largest_frame", load.largest_frame},
          {"baud", load.baud.ceil()}};
}

}  // namespace

Json time_json(const Rational& seconds) {
  return {{"exact", seconds.to_string()}, {"seconds", seconds.to_double()}};
}

Json info_json(const PlanInfo& report) {
  const Plan& plan = *report.plan;
  Json json;
  json["name"] = plan.graph->name;
  json["engine"] = plan.graph->engine_id();
  // Only engines of real hardware have a clock.
  json["moves_hardware"] = plan.graph->has_engine() && plan.graph->engine().entity->asynchronous;
  json["rates"] = Json::object();
  for (const auto& rate : plan.rates) json["rates"][rate.rate_hz.to_string()] = Json::list();
  for (std::size_t n = 0; n < plan.nodes.size(); ++n)
    json["rates"][plan.rates[plan.nodes[n].rate].rate_hz.to_string()].push_back(
        plan.graph->nodes[n].name);
  json["slots"] = plan.schedule.slots ? Json(*plan.schedule.slots) : Json(nullptr);
  Json& rings = json["buffers"] = Json::list();
  for (const auto& ring : plan.rings)
    rings.push_back(Json{{"from", plan.graph->nodes[ring.node].name},
                         {"output", plan.graph->nodes[ring.node].outputs[ring.output].name},
                         {"messages", ring.capacity},
                         {"bytes", ring.capacity * bytes_of(ring.space)}});
  const std::string reason = why_not_vectorized(plan);
  json["why_not_vectorized"] = reason.empty() ? Json(nullptr) : Json(reason);
  json["delays"] = Json::list();
  for (const auto& node : plan.graph->nodes) {
    for (const auto& input : node.inputs) {
      if (input.delay_s == Rational() && !input.max_delay_s) continue;
      Json delay{{"from", name_of_source(*plan.graph, input)}, {"input", input.written}};
      delay["delay"] = time_json(input.delay_s);
      delay["longest"] = time_json(input.max_delay_s.value_or(input.delay_s));
      json["delays"].push_back(std::move(delay));
    }
  }
  json["ages"] = Json::list();
  for (const auto& age : report.ages) json["ages"].push_back(json_of(age));
  json["ages_unknown"] = Json::list();
  for (const Input* input : report.ages_unknown) json["ages_unknown"].push_back(input->written);
  json["budget_ages"] = Json::list();
  for (const auto& compared : report.compared) {
    for (const auto& age : compared.ages)
      json["budget_ages"].push_back(json_of(age, compared.limit));
  }
  Json messages = Json::list();
  for (const auto& message : report.link.messages)
    messages.push_back(Json{{"name", message.name},
                            {"to_engine", message.to_engine},
                            {"rate", message.rate_hz.to_string()},
                            {"bytes", message.bytes}});
  json["link"] = Json{{"sensors", json_of(report.link.sensors)},
                      {"actuators", json_of(report.link.actuators)},
                      {"messages", messages}};
  if (plan.split) json["parts"] = parts_json(plan);
  if (plan.telemetry) json["telemetry"] = telemetry_json(plan);
  if (plan.graph->task) json["task"] = task_json(*plan.graph);
  return json;
}

}  // namespace eagerx::gen
