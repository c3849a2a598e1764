#include "generator/backend/emit/policy_answers.hpp"

#include <fmt/format.h>

#include "generator/support/diagnostics/join.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

/// One whole number takes all outputs; of several each has its own.
bool makes_one_choice(const PolicyUse& use) {
  return use.outputs.size() == 1 && use.outputs.front()->raw.size() == 1;
}

void set_choice(const PolicyUse& use, const Output& to, const std::string& constant, View& item) {
  if (makes_one_choice(use)) {
    item.set("how",
             "as SB3's DQN does: the index of the largest output, from the lowest action on");
    item.set("expression", fmt::format("eagerx::choice({}, eagerx::argmax(output))", constant));
    return;
  }
  item.set("how", to.raw.size() == 1 ? "the index of the largest of its own outputs, from the "
                                       "lowest action on"
                                     : "each number: the index of the largest of its own outputs, "
                                       "from the lowest action on");
  item.set("expression", fmt::format("eagerx::choices({}, output, out)", constant));
}

}  // namespace

bool reads_in_order(const PolicyUse& use, const Network& network) {
  return use.kind(network) != ActionKind::argmax || !makes_one_choice(use);
}

View policy_answers(const PolicyUse& use, const Network& network, const std::string& prefix,
                    Numbers numbers) {
  View answers = list();
  for (const Output* to : use.outputs) {
    const std::string constant = prefix + camel(to->name);
    const std::string type = message_type(to->raw, numbers);
    const std::string output = fmt::format("eagerx::unflatten<{}>(output, out)", type);
    View item = object();
    item.set("field", to->name);
    switch (use.kind(network)) {
      case ActionKind::squashed:
        item.set("how",
                 "squashed policy: from -1…1 to the action's bounds, as SB3's predict() does");
        item.set("expression", fmt::format("eagerx::unscaled({}, {})", output, constant));
        break;
      case ActionKind::argmax:
        set_choice(use, *to, constant, item);
        break;
      case ActionKind::binary:
        item.set("how", "1 where an output is above zero, else 0");
        item.set("expression", fmt::format("eagerx::bits<{}>(output, out)", type));
        break;
      case ActionKind::raw:
        item.set("how", "as SB3's predict() does: clipped to the action's bounds");
        item.set("expression", numbers == Numbers::plain
                                   ? fmt::format("{}.clipped({})", constant, output)
                                   : fmt::format("eagerx::clipped({}, {})", output, constant));
        break;
    }
    answers.push_back(item);
  }
  return answers;
}

namespace {

/// The constants that answers name.
View spaces_of(const PolicyUse& use, Numbers numbers) {
  View spaces = list();
  for (const Output* output : use.outputs) {
    View item = object();
    item.set("type", message_type(output->raw, numbers));
    item.set("constant", "k" + camel(output->name));
    item.set("literal", space_literal(output->raw));
    spaces.push_back(item);
  }
  return spaces;
}

}  // namespace

View policy_node_view(const Plan& plan, const NodePolicy& policy, Numbers numbers) {
  const GraphNode& node = plan.graph->nodes[policy.node];
  View view = object();
  view.set("node_name", node.name);
  View inputs = list();
  for (const Input* input : policy.use.inputs) {
    View item = object();
    item.set("field", input->name);
    inputs.push_back(item);
  }
  view["node_inputs"] = std::move(inputs);
  view["spaces"] = spaces_of(policy.use, numbers);
  view["answers"] = policy_answers(policy.use, *policy.network, "k", numbers);
  view.set("in_order", reads_in_order(policy.use, *policy.network));
  return view;
}

View vectorized_agent_view(const Plan& plan, const Network& network) {
  const PolicyUse use = agent_use(*plan.graph);
  View view = object();
  view.set("observations", fmt::format("{}", join(plan.graph->agent.observations, ", ")));
  view["spaces"] = spaces_of(use, Numbers::simd);
  view["answers"] = policy_answers(use, network, "k", Numbers::simd);
  view.set("in_order", reads_in_order(use, network));
  return view;
}

bool needs_lane_by_lane(const Network& network) {
  return network.profile == Profile::fast || ranges::any_of(network.layers, [](const Layer& layer) {
           return !layer.rounded.empty() || std::holds_alternative<Convolution>(layer.form) ||
                  std::holds_alternative<Pooling>(layer.form);
         });
}

}  // namespace eagerx::gen
