// The state of a stream: everything that a screen or a script shows. Nothing here uses a clock, a
// socket or a terminal.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "generator/tools/monitor/expected.hpp"
#include "generator/tools/monitor/limits.hpp"
#include "generator/tools/monitor/rate_meter.hpp"
#include "generator/tools/monitor/stream.hpp"

namespace eagerx::gen {

inline constexpr std::size_t kHistory = 120;       // messages that a sparkline has at most
inline constexpr std::size_t kMostHistories = 16;  // elements of a message that have one
inline constexpr double kNearLimit = 0.01;         // of the range: `low`, `high`
inline constexpr double kRateTolerance = 0.1;      // of the planned rate: `rate`
// Without a message for so long, and for three planned periods, a channel is `silent`; without a
// plan:
inline constexpr double kSilentS = 0.5, kUnplannedSilentS = 2.0;

/// The current state of a channel.
struct WatchedChannel {
  std::string name;
  std::uint64_t elements = 0;              // of the last message
  std::vector<double> values;              // the first of them
  std::vector<std::deque<float>> history;  // of the first of these, the oldest first
  std::uint64_t messages = 0;
  RateMeter meter;                      // by the clock of real time
  std::optional<std::int64_t> came_ns;  // by the watcher's clock
  std::int64_t late_ns = 0, worst_ns = 0;
  std::optional<double> planned_hz;
  const ExpectedChannel* expected = nullptr;
};

/// The counts of a channel, in addition to its values.
struct ChannelState {
  std::optional<double> measured_hz;
  std::optional<double> age_s;
  std::optional<NearestLimit> limit;
  bool has_come = false, is_silent = false, is_off_rate = false, is_safe = false;

  [[nodiscard]] bool is_at_limit() const { return limit && limit->left <= kNearLimit; }
  /// "silent,high"; "ok"
  [[nodiscard]] std::string words() const;
};

/// The graph's clock against real time, over the last seconds.
class SpeedMeter {
 public:
  void add(std::int64_t real_ns, std::int64_t time_ns);
  [[nodiscard]] std::optional<double> speed() const;

 private:
  struct Pair {
    std::int64_t real_ns, time_ns;
  };
  std::deque<Pair> pairs_;  // a quarter of a second apart
  Pair last_{};
};

class Model final : public StreamListener {
 public:
  /// `expected` must outlive this; null: unknown graph.
  explicit Model(const Expected* expected);

  bool begin(const StreamFacts& facts) override;
  void message(const StreamMessage& message) override;
  void step(const StreamStep& step) override;
  void fault(StreamFault fault, std::uint64_t count) override;

  /// Sets the watcher's clock. Call it before reading a source and before showing anything.
  void now(std::int64_t now_ns) { now_ns_ = now_ns; }

  [[nodiscard]] const std::vector<WatchedChannel>& channels() const { return channels_; }
  [[nodiscard]] ChannelState state(const WatchedChannel& channel) const;
  [[nodiscard]] bool has_messages() const { return messages_ > 0; }
  [[nodiscard]] const StreamFacts& facts() const { return facts_; }
  [[nodiscard]] const Expected* expected() const { return expected_; }
  /// Why the stream is none of the graph; empty: it was not refused.
  [[nodiscard]] const std::string& refusal() const { return refusal_; }
  [[nodiscard]] const StreamStep& last_step() const { return step_; }
  [[nodiscard]] std::uint64_t messages() const { return messages_; }
  [[nodiscard]] std::uint64_t faults(StreamFault fault) const {
    return faults_[static_cast<std::size_t>(fault)];
  }
  [[nodiscard]] std::optional<double> steps_hz() const { return steps_.hz(real_now()); }
  /// Seconds of the graph's clock in one of real time; nothing if that is not known.
  [[nodiscard]] std::optional<double> speed() const { return speed_.speed(); }
  [[nodiscard]] std::int64_t worst_late_ns() const { return worst_ns_; }
  [[nodiscard]] std::int64_t late_ns() const { return late_ns_; }
  [[nodiscard]] std::optional<double> age_s() const;

 private:
  void forget();
  void add_expected();
  WatchedChannel* find(std::string_view name);
  WatchedChannel& add(std::string name);
  void take_values(WatchedChannel& channel, const StreamMessage& message);
  void take_time(WatchedChannel& channel, const StreamMessage& message);
  [[nodiscard]] std::int64_t real_now() const;

  const Expected* expected_;
  StreamFacts facts_;
  std::vector<WatchedChannel> channels_;
  std::map<std::string, std::size_t, std::less<>> places_;
  std::string refusal_;
  StreamStep step_;
  RateMeter steps_;
  std::array<std::uint64_t, kStreamFaults> faults_{};
  std::uint64_t messages_ = 0;
  std::int64_t now_ns_ = 0;
  std::optional<std::int64_t> real_ns_, came_ns_;  // of the last message
  SpeedMeter speed_;
  // The smallest delay of a message behind the graph's clock in this episode.
  std::optional<std::int64_t> least_ns_;
  std::optional<std::uint32_t> episode_;
  std::uint32_t part_ = 0;
  std::int64_t late_ns_ = 0, worst_ns_ = 0;
};

const char* text_of(StreamFault fault);

}  // namespace eagerx::gen
