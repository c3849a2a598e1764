#include "generator/tools/monitor/live_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/support/json/json.hpp"

namespace eagerx::gen {
namespace {

constexpr std::size_t kShownElements = 16;

Json number(const std::optional<double>& value) {
  return value ? Json(*value) : Json(nullptr);
}
double seconds_of(std::int64_t ns) {
  return static_cast<double>(ns) / kNsInSecond;
}

Json channel_json(const Model& model, const WatchedChannel& channel, const Arrivals& arrivals) {
  const ChannelState state = model.state(channel);
  Json json{{"name", channel.name},
            {"messages", channel.messages},
            {"rate_hz", number(state.measured_hz)},
            {"planned_hz", number(channel.planned_hz)},
            {"age_s", number(state.age_s)},
            {"late_s", seconds_of(channel.late_ns)},
            {"worst_s", seconds_of(channel.worst_ns)},
            {"left", state.limit ? Json(state.limit->left) : Json(nullptr)},
            {"state", state.words()},
            {"elements", channel.elements},
            {"value", Json::list()}};
  for (std::size_t i = 0; i < std::min(channel.values.size(), kShownElements); ++i)
    json["value"].push_back(channel.values[i]);
  if (const auto* const came = arrivals.find(channel.name)) {
    json["first"] = came->first;
    json["came_late_s"] = Json::list();
    for (const std::int64_t late_ns : came->late_ns)
      json["came_late_s"].push_back(seconds_of(late_ns));
  }
  return json;
}

}  // namespace

void Arrivals::add(const StreamMessage& message, std::int64_t late_ns) {
  if (!message.seq || !message.real_ns) return;
  const auto found = channels_.find(message.channel);
  Channel& channel =
      found != channels_.end() ? found->second : channels_[std::string(message.channel)];
  const bool follows = *message.seq == channel.first + channel.late_ns.size();
  if (!follows || channel.late_ns.size() == kMost) channel = {*message.seq, {}};
  channel.late_ns.push_back(late_ns);
}

const Arrivals::Channel* Arrivals::find(const std::string& channel) const {
  const auto found = channels_.find(channel);
  return found == channels_.end() ? nullptr : &found->second;
}

foxglove::Topic monitor_topic() {
  return {"/monitor", "eagerx.Monitor",
          R"({"type":"object","properties":{"note":{"type":"string"},"episode":{"type":"integer"},)"
          R"("step":{"type":["integer","null"]},"time_s":{"type":"number"},)"
          R"("faults":{"type":"object"},"channels":{"type":"array","items":{"type":"object"}}}})"};
}

std::string monitor_text(const Model& model, const Arrivals& arrivals, const std::string& note) {
  const StreamStep& step = model.last_step();
  Json json{{"note", note},
            {"has_messages", model.has_messages()},
            {"episode", step.episode},
            {"step", step.step ? Json(*step.step) : Json(nullptr)},
            {"time_s", seconds_of(step.time_ns)},
            {"steps_hz", number(model.steps_hz())},
            {"speed", number(model.speed())},
            {"late_s", seconds_of(model.late_ns())},
            {"worst_s", seconds_of(model.worst_late_ns())},
            {"faults", Json::object()},
            {"channels", Json::list()}};
  for (std::size_t i = 0; i < kStreamFaults; ++i) {
    const auto fault = static_cast<StreamFault>(i);
    if (model.faults(fault) > 0) json["faults"][text_of(fault)] = model.faults(fault);
  }
  for (const WatchedChannel& channel : model.channels())
    json["channels"].push_back(channel_json(model, channel, arrivals));
  return dump_json(json);
}

}  // namespace eagerx::gen
