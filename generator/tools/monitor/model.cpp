#include "generator/tools/monitor/model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

std::string hash_words(std::uint64_t hash) {
  return fmt::format("0x{:016x}", hash);
}

/// Why what the stream says of itself is not the graph; empty: it may be.
std::string refusal_of(const StreamFacts& facts, const Expected& expected) {
  if (!facts.graph.empty() && facts.graph != expected.graph)
    return fmt::format("the stream is of the graph `{}`, and `{}` is `{}`", facts.graph,
                       expected.file, expected.graph);
  if (facts.hash && *facts.hash != expected.hash)
    return fmt::format("the stream is of a program with the hash {}, and that of `{}` has {}",
                       hash_words(*facts.hash), expected.file, hash_words(expected.hash));
  if (!facts.hash && facts.channels.empty()) return "the stream does not say of which graph it is";
  return problem_with_channels(expected, facts.channels);
}

}  // namespace

const char* text_of(StreamFault fault) {
  switch (fault) {
    case StreamFault::damaged:
      return "damaged";
    case StreamFault::foreign:
      return "foreign";
    case StreamFault::late:
      return "out of order";
    case StreamFault::lost:
      return "lost";
    case StreamFault::crowded_out:
      return "too many";
    case StreamFault::dropped:
      return "dropped";
    case StreamFault::late_slots:
      return "late slots";
  }
  return "";
}

std::string ChannelState::words() const {
  if (!has_come) return "missing";
  std::string text;
  const auto add = [&](bool is, const char* word) {
    if (is) text += (text.empty() ? "" : ",") + std::string(word);
  };
  add(is_silent, "silent");
  add(is_off_rate, "rate");
  add(is_at_limit(), limit && limit->is_high ? "high" : "low");
  add(is_safe, "safe");
  return text.empty() ? "ok" : text;
}

void SpeedMeter::add(std::int64_t real_ns, std::int64_t time_ns) {
  constexpr std::int64_t kApartNs = 250'000'000;
  constexpr std::size_t kMost = 9;
  if (pairs_.empty() || real_ns - pairs_.back().real_ns >= kApartNs)
    pairs_.push_back({real_ns, time_ns});
  if (pairs_.size() > kMost) pairs_.pop_front();
  last_ = {real_ns, time_ns};
}

std::optional<double> SpeedMeter::speed() const {
  if (pairs_.empty() || last_.real_ns <= pairs_.front().real_ns) return std::nullopt;
  return static_cast<double>(last_.time_ns - pairs_.front().time_ns) /
         static_cast<double>(last_.real_ns - pairs_.front().real_ns);
}

Model::Model(const Expected* expected) : expected_(expected) {
  add_expected();
}

void Model::add_expected() {
  if (expected_ == nullptr) return;
  for (const ExpectedChannel& each : expected_->channels) {
    if (channels_.size() < kMostStreamChannels) add(each.channel.name);
  }
}

void Model::forget() {
  channels_.clear();
  places_.clear();
  // A stream may list its channels, which can be those of one part; if it does not, expect those of
  // the whole graph.
  if (facts_.channels.empty()) add_expected();
  step_ = {};
  steps_ = {};
  speed_ = {};
  messages_ = 0;
  real_ns_.reset();
  least_ns_.reset();
  episode_.reset();
  late_ns_ = worst_ns_ = 0;
}

bool Model::begin(const StreamFacts& facts) {
  if (expected_ != nullptr) {
    const std::string why = refusal_of(facts, *expected_);
    if (!why.empty()) return refusal_ = why, false;
  }
  refusal_.clear();
  facts_ = facts;
  forget();
  for (const auto& channel : facts_.channels) {
    if (find(channel.name) == nullptr && channels_.size() < kMostStreamChannels) add(channel.name);
  }
  return true;
}

WatchedChannel* Model::find(std::string_view name) {
  const auto found = places_.find(name);
  return found == places_.end() ? nullptr : &channels_[found->second];
}

WatchedChannel& Model::add(std::string name) {
  const auto hz = [](const trace_log::RecordedChannel& channel) {
    return static_cast<double>(channel.rate_num) / static_cast<double>(channel.rate_den);
  };
  places_.emplace(name, channels_.size());
  WatchedChannel& channel = channels_.emplace_back();
  if (expected_ != nullptr) channel.expected = expected_->find(name);
  if (channel.expected != nullptr) {
    channel.planned_hz = hz(channel.expected->channel);
    if (facts_.one_message_a_step)
      channel.planned_hz = std::min(*channel.planned_hz, expected_->step_hz);
  } else {
    const auto said = ranges::find(facts_.channels, name, &trace_log::RecordedChannel::name);
    if (said != facts_.channels.end()) channel.planned_hz = hz(*said);
  }
  if (channel.planned_hz && channels_.size() <= facts_.every.size())
    *channel.planned_hz /= static_cast<double>(facts_.every[channels_.size() - 1]);
  channel.name = std::move(name);
  return channel;
}

void Model::message(const StreamMessage& message) {
  WatchedChannel* channel = find(message.channel);
  if (channel == nullptr) {
    if (channels_.size() == kMostStreamChannels) return fault(StreamFault::crowded_out, 1);
    channel = &add(std::string(message.channel));
  }
  ++messages_;
  ++channel->messages;
  came_ns_ = channel->came_ns = now_ns_;
  take_values(*channel, message);
  take_time(*channel, message);
}

void Model::take_values(WatchedChannel& channel, const StreamMessage& message) {
  channel.elements = message.elements;
  channel.values.assign(message.values.begin(), message.values.end());
  channel.history.resize(std::min(channel.values.size(), kMostHistories));
  for (std::size_t i = 0; i < channel.history.size(); ++i) {
    auto& history = channel.history[i];
    history.push_back(static_cast<float>(channel.values[i]));
    if (history.size() > kHistory) history.pop_front();
  }
}

void Model::take_time(WatchedChannel& channel, const StreamMessage& message) {
  // A reset may take its time.
  if (episode_ != message.episode || part_ != message.part) least_ns_.reset();
  episode_ = message.episode;
  part_ = message.part;
  if (!message.real_ns) return;
  real_ns_ = std::max(real_ns_.value_or(*message.real_ns), *message.real_ns);
  channel.meter.add(*message.real_ns);
  const std::int64_t behind_ns = *message.real_ns - message.time_ns;
  least_ns_ = std::min(least_ns_.value_or(behind_ns), behind_ns);
  channel.late_ns = late_ns_ = behind_ns - *least_ns_;
  channel.worst_ns = std::max(channel.worst_ns, channel.late_ns);
  worst_ns_ = std::max(worst_ns_, channel.late_ns);
}

void Model::step(const StreamStep& step) {
  step_ = step;
  if (!step.real_ns) return;
  steps_.add(*step.real_ns);
  speed_.add(*step.real_ns, step.time_ns);
}

void Model::fault(StreamFault fault, std::uint64_t count) {
  faults_[static_cast<std::size_t>(fault)] += count;
}

std::int64_t Model::real_now() const {
  return facts_.timed_by_sender ? real_ns_.value_or(0) : now_ns_;
}

std::optional<double> Model::age_s() const {
  if (!came_ns_) return std::nullopt;
  return static_cast<double>(now_ns_ - *came_ns_) / kNsInSecond;
}

ChannelState Model::state(const WatchedChannel& channel) const {
  constexpr double kPeriods = 3.0;
  ChannelState state;
  state.has_come = channel.came_ns.has_value();
  if (!state.has_come) return state;
  state.measured_hz = channel.meter.hz(real_now());
  state.age_s = static_cast<double>(now_ns_ - *channel.came_ns) / kNsInSecond;
  const double longest_s =
      channel.planned_hz ? std::max(kSilentS, kPeriods / *channel.planned_hz) : kUnplannedSilentS;
  state.is_silent = *state.age_s > longest_s;
  state.is_off_rate =
      channel.planned_hz && state.measured_hz &&
      std::abs(*state.measured_hz - *channel.planned_hz) > kRateTolerance * *channel.planned_hz;
  if (channel.expected == nullptr) return state;
  state.limit = nearest_limit(channel.values, channel.expected->low, channel.expected->high);
  state.is_safe = is_safe_action(channel.values, channel.expected->safe);
  return state;
}

}  // namespace eagerx::gen
