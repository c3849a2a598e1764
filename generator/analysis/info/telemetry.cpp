#include "generator/graph/plan/telemetry.hpp"

#include <fmt/format.h>

#include "generator/analysis/info/info.hpp"
#include "generator/graph/plan/link.hpp"

namespace eagerx::gen {
namespace {

std::string every_text(std::uint32_t every) {
  return every == 1 ? "every message" : fmt::format("one of {} messages", every);
}

double share_of_line(const TelemetryPlan& telemetry) {
  return telemetry.baud_needed() / telemetry.baud;
}

}  // namespace

std::string telemetry_text(const Plan& plan) {
  if (!plan.telemetry) return {};
  const TelemetryPlan& telemetry = *plan.telemetry;
  std::string text = fmt::format("\ntelemetry of a board over {} baud\n", telemetry.baud);
  for (const TelemetryGroup& group : telemetry.groups) {
    const Rational hz = plan.rates[group.rate].rate_hz / Rational(group.every);
    text += fmt::format("  {:.6g} Hz, {}, {} bytes a frame:", hz.to_double(),
                        every_text(group.every), telemetry_frame_bytes(group.bytes));
    for (const auto& place : group.channels) text += " " + place.port;
    text += "\n";
  }
  text += fmt::format("  {:.0f} bytes/s, {:.2f} of the line, at most {}\n", telemetry.bytes_per_s,
                      share_of_line(telemetry), telemetry.share.to_string());
  if (telemetry.wanted_bytes_per_s)
    text += fmt::format("  all messages would be {:.0f} bytes/s, {:.2f} of the line\n",
                        *telemetry.wanted_bytes_per_s,
                        *telemetry.wanted_bytes_per_s * kBitsOfByte / telemetry.baud);
  return text;
}

Json telemetry_json(const Plan& plan) {
  const TelemetryPlan& telemetry = *plan.telemetry;
  Json json{{"baud", telemetry.baud},
            {"share", telemetry.share.to_double()},
            {"bytes_per_s", telemetry.bytes_per_s},
            {"load", share_of_line(telemetry)}};
  Json& groups = json["groups"] = Json::list();
  for (const TelemetryGroup& group : telemetry.groups) {
    Json channels = Json::list();
    for (const auto& place : group.channels) channels.push_back(place.port);
    groups.push_back(Json{{"rate", plan.rates[group.rate].rate_hz.to_string()},
                          {"every", group.every},
                          {"frame_bytes", telemetry_frame_bytes(group.bytes)},
                          {"channels", channels}});
  }
  return json;
}

}  // namespace eagerx::gen
