#include "generator/emit/policy_answers.hpp"

#include <fmt/format.h>

namespace eagerx::gen {

View policy_answers(const PolicyUse& use, const Network& network, const std::string& prefix) {
  View answers = list();
  for (const Output* to : use.outputs) {
    const std::string constant = prefix + camel(to->name);
    const std::string output =
        fmt::format("eagerx::unflatten<{}>(output, out)", message_type(to->raw));
    View item = object();
    item.set("field", to->name);
    switch (use.kind(network)) {
      case ActionKind::squashed:
        item.set("how",
                 "squashed policy: from -1…1 to the action's bounds, as SB3's predict() does");
        item.set("expression", fmt::format("eagerx::unscaled({}, {})", output, constant));
        break;
      case ActionKind::argmax:
        item.set("how",
                 "as SB3's DQN does: the index of the largest output, from the lowest action on");
        item.set("expression", fmt::format("eagerx::choice({}, eagerx::argmax(output))", constant));
        break;
      case ActionKind::raw:
        item.set("how", "as SB3's predict() does: clipped to the action's bounds");
        item.set("expression", fmt::format("{}.clipped({})", constant, output));
        break;
    }
    answers.push_back(item);
  }
  return answers;
}

View policy_node_view(const Plan& plan, const ProgramNames& names, const NodePolicy& policy) {
  const GraphNode& node = plan.graph->nodes[policy.node];
  View view = object();
  view.set("node_name", node.name);
  view.set("place", names.place(node.span));
  View inputs = list(), spaces = list();
  for (const Input* input : policy.use.inputs) {
    View item = object();
    item.set("field", input->name);
    inputs.push_back(item);
  }
  for (const Output* output : policy.use.outputs) {
    View item = object();
    item.set("type", message_type(output->raw));
    item.set("constant", "k" + camel(output->name));
    item.set("literal", space_literal(output->raw));
    spaces.push_back(item);
  }
  view["node_inputs"] = std::move(inputs);
  view["spaces"] = std::move(spaces);
  view["answers"] = policy_answers(policy.use, *policy.network, "k");
  view.set("in_order", policy.use.kind(*policy.network) != ActionKind::argmax);
  return view;
}

}  // namespace eagerx::gen
