// What goes over the links of a graph with parts.
#include <fmt/format.h>

#include <cmath>

#include "generator/info/info.hpp"

namespace eagerx::gen {
namespace {

constexpr double kUsualBaud = 115200.0;

/// "pendulum.theta", as link_of() has it.
std::string name_of(const Graph& graph, const Channel& channel) {
  const GraphNode& node = graph.nodes[channel.node];
  const Output& output = node.outputs[channel.output];
  if (!output.sensors.empty()) return output.sensors.front();
  return (node.role == NodeRole::environment ? "actions" : node.name) + "." + output.name;
}

/// "pendulum.theta 4 B at 30 Hz, …"
std::string messages_text(const Plan& plan, const std::vector<bool>& crosses) {
  std::vector<std::string> texts;
  for (std::size_t c = 0; c < plan.channels.size(); ++c) {
    if (!crosses[c]) continue;
    const Channel& channel = plan.channels[c];
    const GraphNode& node = plan.graph->nodes[channel.node];
    texts.push_back(fmt::format("{} ({} B at {} Hz)", name_of(*plan.graph, channel),
                                bytes_of(node.outputs[channel.output].space),
                                node.rate_hz.to_string()));
  }
  return fmt::format("{}", fmt::join(texts, ", "));
}

/// "goes on while up to 3 exchanges are on their way"
std::string ahead_text(const PartLink& link) {
  if (link.depth > 1)
    return fmt::format("the hub goes on while up to {} exchanges are on their way", link.depth);
  return fmt::format("the hub waits for each exchange{}: {}", link.posts ? " when it needs it" : "",
                     link.why_not_ahead);
}

Json names_json(const Plan& plan, const std::vector<bool>& crosses) {
  Json names = Json::list();
  for (std::size_t c = 0; c < plan.channels.size(); ++c)
    if (crosses[c]) names.push_back(Json(name_of(*plan.graph, plan.channels[c])));
  return names;
}

double steps_per_s(const Plan& plan) {
  return plan.graph->environment().rate_hz.to_double();
}

}  // namespace

double bytes_on_line(const PartLink& link) {
  return link.part_bytes + link.hub_bytes + 2.0 * static_cast<double>(kFrameBytes) * link.exchanges;
}
double baud_of(const Plan& plan, const PartLink& link) {
  return static_cast<double>(kBitsOfByte) * bytes_on_line(link) * steps_per_s(plan);
}

std::string parts_text(const Plan& plan) {
  if (!plan.split) return {};
  std::string text = "\nover the links to the parts, in lockstep\n";
  for (std::size_t part = 0; part < plan.split->links.size(); ++part) {
    const PartLink& link = plan.split->links[part];
    const PlacedPart& placed = plan.graph->placement->parts[part];
    text += fmt::format("  {} ({}{}{}): ", placed.name, placed.target->id.value,
                        placed.host.empty() ? "" : ", on ", placed.host);
    if (link.exchanges == 0.0) {
      text += "how much is not known, as the rates are too far apart\n";
    } else {
      const double ms = 1e3 * static_cast<double>(kBitsOfByte) * bytes_on_line(link) / kUsualBaud;
      text += fmt::format(
          "{:.4g} exchanges and {:.4g} bytes a step with their frames; at 115200 baud {:.3g} ms of "
          "{:.4g}, {:.0f} % of a line in real time\n",
          link.exchanges, bytes_on_line(link), ms, 1e3 / steps_per_s(plan),
          std::ceil(100.0 * baud_of(plan, link) / kUsualBaud));
    }
    text += fmt::format("    {}\n", ahead_text(link));
    text += fmt::format("    to it: {}\n", messages_text(plan, link.to_part));
    text += fmt::format("    from it: {}\n", messages_text(plan, link.to_hub));
  }
  return text;
}

Json parts_json(const Plan& plan) {
  Json parts = Json::list();
  for (std::size_t part = 0; part < plan.split->links.size(); ++part) {
    const PartLink& link = plan.split->links[part];
    const PlacedPart& placed = plan.graph->placement->parts[part];
    const bool known = link.exchanges > 0.0;
    parts.push_back(
        Json{{"name", placed.name},
             {"target", placed.target->id.value},
             {"host", placed.host.empty() ? Json(nullptr) : Json(placed.host)},
             {"to_part", names_json(plan, link.to_part)},
             {"to_hub", names_json(plan, link.to_hub)},
             {"exchanges_a_step", known ? Json(link.exchanges) : Json(nullptr)},
             {"bytes_a_step", known ? Json(bytes_on_line(link)) : Json(nullptr)},
             {"exchanges_on_their_way", Json(static_cast<double>(link.depth))},
             {"why_not_more", link.depth > 1 ? Json(nullptr) : Json(link.why_not_ahead)},
             {"baud", known ? Json(baud_of(plan, link)) : Json(nullptr)}});
  }
  return parts;
}

void check_parts_budget(const Plan& plan, const YamlValue& entry, Diagnostics& diagnostics) {
  const auto limit = Rational::parse(entry.text);
  if (!limit || !plan.split) return;
  for (std::size_t part = 0; part < plan.split->links.size(); ++part) {
    const PartLink& link = plan.split->links[part];
    const PlacedPart& placed = plan.graph->placement->parts[part];
    const double baud = baud_of(plan, link);
    if (link.exchanges > 0.0 && baud <= limit->to_double()) continue;
    auto& problem = diagnostics.error(
        "E0420", entry.span,
        link.exchanges == 0.0
            ? fmt::format("how much goes over the link to part `{}` is not known", placed.name)
            : fmt::format("the link to part `{}` needs {:.0f} baud, {:.0f} over its budget of {}",
                          placed.name, std::ceil(baud), std::ceil(baud - limit->to_double()),
                          limit->to_string()));
    problem.notes.push_back(
        {fmt::format("to it go {}; from it come {}", messages_text(plan, link.to_part),
                     messages_text(plan, link.to_hub)),
         placed.span, ""});
  }
}

}  // namespace eagerx::gen
