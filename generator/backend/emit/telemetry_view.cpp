// The telemetry of boards: the tables in graph.hpp, and telemetry.json for readers.
#include <fmt/format.h>

#include "generator/backend/emit/names.hpp"
#include "generator/support/diagnostics/join.hpp"

namespace eagerx::gen {
namespace {

constexpr const char* kIsLast = "is_last";

View shape_view(const Space& space) {
  View shape = list();
  for (std::size_t i = 0; i < space.shape.size(); ++i) {
    View item = object();
    item.set("size", fmt::format("{}", space.shape[i]));
    item.set(kIsLast, i + 1 == space.shape.size());
    shape.push_back(std::move(item));
  }
  return shape;
}

View channels_view(const Plan& plan, const TelemetryGroup& group) {
  View channels = list();
  for (const auto& place : group.channels) {
    const Channel& channel = plan.channels[place.channel];
    const Space& space = plan.graph->nodes[channel.node].outputs[channel.output].space;
    View item = object();
    item.set("channel", channel.name);
    item.set("port", place.port);
    item.set("dtype", std::string(to_string(space.dtype)));
    item["shape"] = shape_view(space);
    item.set("offset", fmt::format("{}", place.offset));
    item.set(kIsLast, &place == &group.channels.back());
    channels.push_back(std::move(item));
  }
  return channels;
}

View group_view(const Plan& plan, const TelemetryGroup& group) {
  const Rational& rate = plan.rates[group.rate].rate_hz;
  std::vector<std::string> ports;
  for (const auto& place : group.channels) ports.push_back(place.port);
  View item = object();
  item.set("literal", fmt::format("{{{}, 0x{:04x}, {}}}", group.bytes,
                                  (std::uint32_t{1} << group.channels.size()) - 1, group.every));
  item.set("rate", rate.to_string());
  item.set("ports", fmt::format("{}", join(ports, ", ")));
  item.set("num", fmt::format("{}", rate.num()));
  item.set("den", fmt::format("{}", rate.den()));
  item.set("every", fmt::format("{}", group.every));
  item.set("bytes", fmt::format("{}", group.bytes));
  item["channels"] = channels_view(plan, group);
  item.set(kIsLast, &group == &plan.telemetry->groups.back());
  return item;
}

View places_view(const Plan& plan) {
  std::vector<std::string> literals(plan.channels.size(), "{}");
  for (std::size_t g = 0; g < plan.telemetry->groups.size(); ++g) {
    const auto& channels = plan.telemetry->groups[g].channels;
    for (std::size_t bit = 0; bit < channels.size(); ++bit)
      literals[channels[bit].channel] = fmt::format("{{{}, {}, {}}}", g, bit, channels[bit].offset);
  }
  View places = list();
  for (std::size_t i = 0; i < literals.size(); ++i) {
    View item = object();
    item.set("literal", literals[i]);
    item.set("channel", plan.channels[i].name);
    places.push_back(std::move(item));
  }
  return places;
}

}  // namespace

View telemetry_view(const Plan& plan) {
  if (!plan.telemetry) return View(false);
  const TelemetryPlan& telemetry = *plan.telemetry;
  View view = object();
  view.set("baud", fmt::format("{}", telemetry.baud));
  view.set("cells", fmt::format("{}", telemetry.cells));
  view.set("greet_every", fmt::format("{}", telemetry.greet_every));
  view.set("share", fmt::format("{}", telemetry.share.to_double()));
  view.set("bytes_per_s", fmt::format("{:.0f}", telemetry.bytes_per_s));
  View groups = list();
  for (const auto& group : telemetry.groups) groups.push_back(group_view(plan, group));
  view["groups"] = std::move(groups);
  view["places"] = places_view(plan);
  return view;
}

}  // namespace eagerx::gen
