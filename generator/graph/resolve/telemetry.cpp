#include "generator/graph/resolve/telemetry.hpp"

#include <fmt/format.h>

#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

/// Everything that has a channel of its own, by the names that connections call it.
std::vector<TelemetryChannel> published(const UnresolvedGraph& draft) {
  const Graph& graph = draft.graph;
  std::vector<TelemetryChannel> all;
  for (std::size_t n = 0; n < graph.nodes.size(); ++n) {
    const GraphNode& node = graph.nodes[n];
    if (node.drawn) continue;
    const std::string owner = node.role == NodeRole::environment ? "actions" : node.name;
    for (std::size_t o = 0; o < node.outputs.size(); ++o) {
      const Output& output = node.outputs[o];
      for (const std::string& sensor : output.sensors) all.push_back({n, o, sensor, output.span});
      if (output.sensors.empty()) all.push_back({n, o, owner + "." + output.name, output.span});
    }
  }
  return all;
}

void report_unknown(UnresolvedGraph& draft, const Spanned<std::string>& name,
                    const std::vector<TelemetryChannel>& all) {
  std::vector<std::string> known;
  known.reserve(all.size());
  for (const auto& channel : all) known.push_back(channel.port);
  auto& problem = draft.diagnostics.error(
      "E0307", name.span, fmt::format("nothing sends `{}` in this graph", name.value));
  if (name.value.starts_with("observations.")) {
    problem.help = "an observation is what arrives: name the port that it is connected to";
    return;
  }
  problem.help = suggestion(name.value, known, "the graph sends nothing");
}

/// Programs for Linux have no telemetry; a board that is a part has no port for it.
void check_parts(UnresolvedGraph& draft) {
  for (const PlacedPart& part : draft.graph.placement->parts) {
    if (!part.target->system.empty()) continue;
    auto& problem = draft.diagnostics.error(
        "E0342", draft.spec.telemetry->span,
        fmt::format("the serial port of `{}` is taken: its link needs it", part.target->id.value));
    problem.notes.push_back({fmt::format("part `{}` is placed here", part.name), part.span, ""});
    problem.help =
        "leave out `telemetry:`; the program on Linux has every message of the board, and "
        "`--publish` sends them";
    return;
  }
  draft.graph.telemetry.reset();
}

}  // namespace

void resolve_telemetry(UnresolvedGraph& draft) {
  if (!draft.spec.telemetry || draft.graph.nodes.empty()) return;
  const TelemetrySpec& spec = *draft.spec.telemetry;
  Telemetry& telemetry = draft.graph.telemetry.emplace();
  telemetry.span = telemetry.baud_span = spec.span;
  if (spec.share) telemetry.share = spec.share->value;
  if (spec.rate) telemetry.rate_hz = spec.rate->value;
  if (spec.baud) {
    telemetry.baud = static_cast<std::uint32_t>(spec.baud->value.floor());
    telemetry.baud_span = spec.baud->span;
  }
  const std::vector<TelemetryChannel> all = published(draft);
  for (const auto& name : spec.channels) {
    const auto found = ranges::find(all, name.value, &TelemetryChannel::port);
    if (found == all.end()) {
      const std::string owner = name.value.substr(0, name.value.find('.'));
      if (!draft.erroneous.contains(owner)) report_unknown(draft, name, all);
      continue;
    }
    const auto earlier = ranges::find_if(telemetry.channels, [&](const auto& channel) {
      return channel.node == found->node && channel.output == found->output;
    });
    if (earlier != telemetry.channels.end()) {
      draft.diagnostics
          .error("E0206", name.span,
                 earlier->port == name.value
                     ? fmt::format("`{}` is listed twice", name.value)
                     : fmt::format("`{}` is the message of `{}`", name.value, earlier->port))
          .notes.push_back({"first here", earlier->span, ""});
      continue;
    }
    telemetry.channels.push_back({found->node, found->output, name.value, name.span});
  }
  if (draft.graph.placement) check_parts(draft);
}

}  // namespace eagerx::gen
