// Limits of a part in another language.
#include <fmt/format.h>

#include <algorithm>

#include "generator/backend/languages/layout.hpp"

namespace eagerx::gen {
namespace {

class LanguageCheck {
 public:
  LanguageCheck(const Plan& plan, std::size_t part, Diagnostics& diagnostics)
      : plan_(plan), graph_(*plan.graph), part_(part), diagnostics_(diagnostics) {}

  void run() {
    const Placement& placement = *graph_.placement;
    if (placement.part_of[Graph::kEnvironment] == part_)
      refuse(placement.parts[part_].span, "it has the agent",
             "place only nodes there: a policy is a node, too, as `nodes: {NAME: {policy: FILE}}` "
             "or written in that language");
    for (const GraphNode& node : graph_.nodes) {
      if (!node.is_reset_node()) continue;
      refuse(node.span, fmt::format("the graph has the reset node `{}`", node.name),
             "take reset nodes out, or give the part a target of C++");
      break;
    }
    for (std::size_t n = 0; n < graph_.nodes.size(); ++n)
      if (placement.part_of[n] == part_ && n != Graph::kEnvironment) check(n);
  }

 private:
  void check(std::size_t n) {
    const GraphNode& node = graph_.nodes[n];
    constexpr const char* kConvert =
        "leave the processor out, and convert in the node, which is yours";
    for (std::size_t i = 0; i < node.inputs.size(); ++i) {
      const Input& input = node.inputs[i];
      if (input.processor)
        refuse(input.span, fmt::format("`{}` has a processor", input.written), kConvert);
      if (input.max_delay_s || input.entity_sets_delay)
        refuse(input.span, fmt::format("the delay of `{}` changes at a reset", input.written),
               "give it a fixed delay");
      if (plan_.nodes[n].receptions[i].count == Reception::Count::arrived)
        refuse(input.span, fmt::format("`{}` takes what has arrived", input.written),
               "leave out `sync: false`");
    }
    for (const Output& output : node.outputs)
      if (output.processor)
        refuse(output.span, fmt::format("`{}.{}` has a processor", node.name, output.name),
               kConvert);
    for (const State& state : node.states) {
      const bool sampled = state.random && state.random->kind != RandomSpec::Kind::value;
      if (sampled || (state.random && state.processor))
        refuse(state.span,
               fmt::format("the state `{}.{}` is sampled at a reset", node.name, state.name),
               "give it a value: `states: {NAME: {value: 0.5}}`");
    }
  }

  void refuse(Span span, const std::string& why, const char* help) {
    const PlacedPart& part = graph_.placement->parts[part_];
    diagnostics_
        .error("E0350", span,
               fmt::format("part `{}` cannot be a program in another language: {}", part.name, why))
        .help = help;
  }

  const Plan& plan_;
  const Graph& graph_;
  std::size_t part_;
  Diagnostics& diagnostics_;
};

}  // namespace

void check_languages(const Plan& plan, std::size_t part, Diagnostics& diagnostics) {
  LanguageCheck(plan, part, diagnostics).run();
}

}  // namespace eagerx::gen
