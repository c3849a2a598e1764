// Policies with what they expect of the world.
#include <fmt/format.h>

#include "generator/policy/network/cost.hpp"
#include "generator/tools/page/page.hpp"

namespace eagerx::gen {
namespace {

Json numbers(const std::vector<double>& values) {
  Json list = Json::list();
  for (const double value : values) list.push_back(value);
  return list;
}

Json layers_json(const Network& network) {
  Json layers = Json::list();
  for (const Layer& layer : network.layers) {
    const LayerCost cost = cost_of(layer);
    const bool plain = layer.is_dense() && layer.activation == Activation::identity && !layer.norm;
    const std::string note = plain ? std::string() : note_of(layer);
    layers.push_back(Json{{"inputs", layer.inputs},
                          {"outputs", layer.outputs},
                          {"note", note.empty() ? note : note.substr(1)},
                          {"parameters", cost.parameters},
                          {"bytes", cost.bytes},
                          {"multiply_adds", cost.multiply_adds},
                          {"remembers", layer.remembers()}});
  }
  return layers;
}

Json contract_json(const Network& network) {
  const PolicyContract& contract = network.contract;
  Json json{{"algorithm", contract.algorithm},
            {"action", to_string(network.action_kind())},
            {"action_low", numbers(contract.action_low)},
            {"action_high", numbers(contract.action_high)},
            {"observation_low", numbers(contract.observation_low)},
            {"observation_high", numbers(contract.observation_high)},
            {"observations", Json::list()}};
  for (const NamedPart& part : contract.observations)
    json["observations"].push_back(Json{{"name", part.name}, {"size", part.size}});
  json["rate_hz"] = contract.rate_hz ? Json(*contract.rate_hz) : Json(nullptr);
  json["normalization"] = nullptr;
  if (const auto& statistics = network.normalization)
    json["normalization"] = Json{{"mean", numbers(statistics->mean)},
                                 {"variance", numbers(statistics->variance)},
                                 {"clip", statistics->clip},
                                 {"epsilon", statistics->epsilon},
                                 {"source", statistics->source}};
  return json;
}

/// A policy's inputs from the graph, and the use of its answer.
Json use_json(const PolicyUse& use, const Network& network, const PageContents& contents) {
  Json json{{"rate", use.rate_hz.to_string()},
            {"line", contents.sources->place_in(contents.spec->file, use.span).line},
            {"kind", to_string(use.kind(network))},
            {"inputs", Json::list()},
            {"outputs", Json::list()}};
  for (const Input* input : use.inputs)
    json["inputs"].push_back(Json{{"name", use.in + input->name},
                                  {"space", input->space.describe()},
                                  {"window", input->window},
                                  {"low", numbers(input->space.low)},
                                  {"high", numbers(input->space.high)}});
  for (const Output* output : use.outputs)
    json["outputs"].push_back(Json{{"name", use.out + output->name},
                                   {"space", output->space.describe()},
                                   {"low", numbers(output->space.low)},
                                   {"high", numbers(output->space.high)}});
  return json;
}

Json policy_json(const std::string& name, const PolicyUse& use, const Network& network,
                 const PageContents& contents) {
  return Json{{"name", name},
              {"file", network.file},
              {"format", network.format},
              {"inputs", network.inputs()},
              {"outputs", network.outputs()},
              {"profile", network.profile == Profile::fast ? "fast" : "exact"},
              {"layers", layers_json(network)},
              {"contract", contract_json(network)},
              {"assumed", Json(network.assumed)},
              {"ignored", Json(network.ignored)},
              {"known_answers", network.self_test.size()},
              {"use", use_json(use, network, contents)}};
}

}  // namespace

Json policies_json(const PageContents& contents) {
  const Graph& graph = *contents.info->plan->graph;
  Json list = Json::list();
  if (contents.policies->agent)
    list.push_back(policy_json("agent", agent_use(graph), *contents.policies->agent, contents));
  for (const NodePolicy& policy : node_policies(*contents.spec, graph, *contents.policies))
    list.push_back(
        policy_json(graph.nodes[policy.node].name, policy.use, *policy.network, contents));
  return list;
}

}  // namespace eagerx::gen
