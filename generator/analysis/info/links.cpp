// Traffic on the links of a graph with parts.
#include <fmt/format.h>

#include <cmath>

#include "generator/analysis/info/info.hpp"
#include "generator/support/diagnostics/join.hpp"

namespace eagerx::gen {
namespace {

constexpr double kUsualBaud = 115200.0;  // of boards here

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
  return texts.empty() ? "nothing" : fmt::format("{}", join(texts, ", "));
}

/// "continues while up to 4 exchanges are in flight: `arm.u` reads it with `delay: 0.1`"
std::string pipelining_text(const PartLink& link) {
  const std::string what =
      link.depth > 1
          ? fmt::format("continues while up to {} exchanges are in flight", link.depth)
          : fmt::format("waits for a message where it is {}", link.is_pipelined ? "read" : "sent");
  return fmt::format("{}: {}", what, link.why_no_more);
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

/// "    a step      1 exchange, …"
std::string row(const char* what, const std::string& value) {
  return fmt::format("    {:<11} {}\n", what, value);
}

/// The time that the messages of a step need, which one program does not.
std::string time_rows(const Plan& plan, const PartLink& link,
                      const std::optional<Spanned<Rational>>& limit) {
  const double baud = baud_of(plan, link);
  const double ms = 1e3 * static_cast<double>(kBitsOfByte) * bytes_on_line(link) / kUsualBaud;
  std::string text =
      row("real time", fmt::format("{:.4g} bytes/s, {:.0f} % of a serial line at 115200 baud",
                                   bytes_on_line(link) * steps_per_s(plan),
                                   std::ceil(100.0 * baud / kUsualBaud))) +
      row("added age", fmt::format("none in lockstep, where a step waits; in real time over such a "
                                   "line {:.3g} of the {:.4g} ms of a step",
                                   ms, 1e3 / steps_per_s(plan)));
  if (limit)
    text += row("budget", fmt::format("{} baud, of which it needs {:.0f}", limit->value.to_string(),
                                      std::ceil(baud)));
  return text;
}

std::string part_text(const Plan& plan, std::size_t part,
                      const std::optional<Spanned<Rational>>& limit) {
  const PartLink& link = plan.split->links[part];
  const PlacedPart& placed = plan.graph->placement->parts[part];
  const std::string machine = !placed.host.empty()            ? " on " + placed.host
                              : placed.target->system.empty() ? ""
                                                              : " on this machine";
  return fmt::format("  {}, for {}{}\n", placed.name, placed.target->id.value, machine) +
         row("takes", messages_text(plan, link.to_part)) +
         row("gives", messages_text(plan, link.to_hub)) + row("a step", load_of_part(plan, part)) +
         row("the hub", pipelining_text(link)) +
         (link.exchanges == 0.0 ? std::string() : time_rows(plan, link, limit));
}

}  // namespace

double bytes_on_line(const PartLink& link) {
  return link.part_bytes + link.hub_bytes + 2.0 * static_cast<double>(kFrameBytes) * link.exchanges;
}
double baud_of(const Plan& plan, const PartLink& link) {
  return static_cast<double>(kBitsOfByte) * bytes_on_line(link) * steps_per_s(plan);
}

std::string load_of_part(const Plan& plan, std::size_t part) {
  const PartLink& link = plan.split->links[part];
  if (link.exchanges == 0.0) return "not known, as the rates are too far apart";
  return fmt::format("{:.4g} exchange{}, {:.4g} bytes with their frames", link.exchanges,
                     link.exchanges == 1.0 ? "" : "s", bytes_on_line(link));
}

std::string parts_text(const Plan& plan, const std::optional<BudgetSpec>& budget) {
  if (!plan.split) return {};
  const auto limit = budget ? budget->parts : std::nullopt;
  std::string text = "\nparts: programs of their own, each with a link to the hub, `host`\n";
  double exchanges = 0.0, bytes = 0.0;
  const auto& links = plan.split->links;
  for (std::size_t part = 0; part < links.size(); ++part) {
    text += part_text(plan, part, limit);
    exchanges += links[part].exchanges;
    bytes += bytes_on_line(links[part]);
  }
  if (links.size() > 1)
    text +=
        fmt::format("  all of them: {:.4g} exchanges and {:.4g} bytes a step\n", exchanges, bytes);
  return text;
}

Json parts_json(const Plan& plan) {
  Json parts = Json::list();
  for (std::size_t part = 0; part < plan.split->links.size(); ++part) {
    const PartLink& link = plan.split->links[part];
    const PlacedPart& placed = plan.graph->placement->parts[part];
    const bool known = link.exchanges > 0.0;
    parts.push_back(Json{{"name", placed.name},
                         {"target", placed.target->id.value},
                         {"host", placed.host.empty() ? Json(nullptr) : Json(placed.host)},
                         {"to_part", names_json(plan, link.to_part)},
                         {"to_hub", names_json(plan, link.to_hub)},
                         {"exchanges_a_step", known ? Json(link.exchanges) : Json(nullptr)},
                         {"bytes_a_step", known ? Json(bytes_on_line(link)) : Json(nullptr)},
                         {"exchanges_on_their_way", Json(static_cast<double>(link.depth))},
                         {"why_not_more", Json(link.why_no_more)},
                         {"baud", known ? Json(baud_of(plan, link)) : Json(nullptr)}});
  }
  return parts;
}

void check_parts_budget(const Plan& plan, const Spanned<Rational>& limit,
                        Diagnostics& diagnostics) {
  if (!plan.split) return;
  const double allowed = limit.value.to_double();
  for (std::size_t part = 0; part < plan.split->links.size(); ++part) {
    const PartLink& link = plan.split->links[part];
    const PlacedPart& placed = plan.graph->placement->parts[part];
    const double baud = baud_of(plan, link);
    if (link.exchanges > 0.0 && baud <= allowed) continue;
    auto& problem = diagnostics.error(
        "E0420", limit.span,
        link.exchanges == 0.0
            ? fmt::format("how much goes over the link to part `{}` is not known", placed.name)
            : fmt::format("the link to part `{}` needs {:.0f} baud, {:.0f} over its budget of {}",
                          placed.name, std::ceil(baud), std::ceil(baud - allowed),
                          limit.value.to_string()));
    problem.notes.push_back(
        {fmt::format("to it: {}; from it: {}", messages_text(plan, link.to_part),
                     messages_text(plan, link.to_hub)),
         placed.span, ""});
  }
}

}  // namespace eagerx::gen
