#include "generator/graph/plan/telemetry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "generator/graph/plan/link.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

// runtime/eagerx/link/telemetry.hpp
constexpr std::uint64_t kHeaderBytes = 8;
constexpr std::uint64_t kMostRecordBytes = 2048;
constexpr std::size_t kMostChannels = 16;
constexpr std::size_t kMostGroups = 254;
constexpr std::uint64_t kGreetingBytes = 28;
constexpr std::size_t kLeastCells = 8;
constexpr std::size_t kCellsOfGroup = 4;

class Teller {
 public:
  Teller(const Plan& plan, Diagnostics& diagnostics)
      : plan_(plan), telemetry_(*plan.graph->telemetry), diagnostics_(diagnostics) {
    result_.share = telemetry_.share;
    result_.baud = telemetry_.baud;
  }

  std::optional<TelemetryPlan> run() {
    if (!fill_groups() || !find_rate()) return std::nullopt;
    double records_per_s = 0.0;
    for (const auto& group : result_.groups) records_per_s += sent_hz(group);
    result_.greet_every = static_cast<std::uint32_t>(std::max(1.0, std::ceil(records_per_s)));
    result_.cells = std::bit_ceil(std::max(kLeastCells, kCellsOfGroup * result_.groups.size()));
    result_.bytes_per_s = load();
    return std::move(result_);
  }

 private:
  const Space& space_of(const TelemetryChannel& channel) const {
    return plan_.graph->nodes[channel.node].outputs[channel.output].space;
  }
  /// Multiples of four bytes, so that what follows is copied in words.
  static std::uint64_t padded(std::uint64_t bytes) { return (bytes + 3) / 4 * 4; }

  /// Of a record. Inputs that go by the clock let nodes leave out messages, each on its own.
  std::size_t most_channels() const { return plan_.graph->asynchronous ? 1 : kMostChannels; }

  /// By rate, fastest first; what is larger than a record goes into several.
  bool fill_groups() {
    bool fits = true;
    for (std::size_t rate = 0; rate < plan_.rates.size(); ++rate) {
      TelemetryGroup* group = nullptr;
      for (const auto& channel : telemetry_.channels) {
        if (plan_.nodes[channel.node].rate != rate) continue;
        const std::uint64_t bytes = bytes_of(space_of(channel));
        if (bytes > kMostRecordBytes - kHeaderBytes) {
          diagnostics_
              .error("E0426", channel.span,
                     fmt::format("a message of `{}` has {} bytes, more than telemetry takes",
                                 channel.port, bytes))
              .help =
              fmt::format("telemetry takes up to {} bytes", kMostRecordBytes - kHeaderBytes);
          fits = false;
          continue;
        }
        if (group == nullptr || group->channels.size() == most_channels() ||
            group->bytes + padded(bytes) > kMostRecordBytes)
          group = &result_.groups.emplace_back(TelemetryGroup{rate, 1, kHeaderBytes, {}});
        group->channels.push_back({channel_of(channel), channel.port, group->bytes});
        group->bytes += padded(bytes);
      }
    }
    if (result_.groups.size() <= kMostGroups) return fits;
    diagnostics_.error("E0426", telemetry_.span,
                       fmt::format("telemetry with {} groups of channels: at most {} can be "
                                   "distinguished",
                                   result_.groups.size(), kMostGroups));
    return false;
  }

  std::size_t channel_of(const TelemetryChannel& wanted) const {
    const auto found = ranges::find_if(plan_.channels, [&](const Channel& channel) {
      return channel.node == wanted.node && channel.output == wanted.output;
    });
    return static_cast<std::size_t>(found - plan_.channels.begin());
  }

  const Rational& rate_of(const TelemetryGroup& group) const {
    return plan_.rates[group.rate].rate_hz;
  }
  double sent_hz(const TelemetryGroup& group) const {
    return rate_of(group).to_double() / static_cast<double>(group.every);
  }
  double bytes_per_s(const TelemetryGroup& group) const {
    return sent_hz(group) * static_cast<double>(telemetry_frame_bytes(group.bytes));
  }
  double load() const {
    double bytes = static_cast<double>(telemetry_frame_bytes(kGreetingBytes));  // once a second
    for (const auto& group : result_.groups) bytes += bytes_per_s(group);
    return bytes;
  }
  double allowed() const {
    return telemetry_.share.to_double() * telemetry_.baud / static_cast<double>(kBitsOfByte);
  }

  /// No channel more often than this.
  void set_rate(const Rational& most_hz) {
    for (auto& group : result_.groups) {
      const std::int64_t every = (rate_of(group) / most_hz).ceil();
      group.every = static_cast<std::uint32_t>(std::max<std::int64_t>(every, 1));
    }
  }

  /// The fastest channel gives a message of n, the least n that fits; slower channels all of theirs
  /// until they would be more than that.
  bool find_rate() {
    const Rational fastest = rate_of(result_.groups.front());
    const std::int64_t slowest = std::max<std::int64_t>(fastest.floor(), 1);
    std::int64_t least = 1;
    if (telemetry_.rate_hz)
      least = std::max<std::int64_t>((fastest / *telemetry_.rate_hz).ceil(), 1);
    const auto fits = [&](std::int64_t n) {
      set_rate(fastest / Rational(n));
      return load() <= allowed();
    };
    if (fits(least)) return true;
    result_.wanted_bytes_per_s = load();
    std::int64_t too_fast = least, slow = std::max(slowest, least);
    if (!fits(slow)) return too_much();
    while (slow - too_fast > 1) {
      const std::int64_t middle = too_fast + (slow - too_fast) / 2;
      (fits(middle) ? slow : too_fast) = middle;
    }
    fits(slow);
    return true;
  }

  bool too_much() {
    const auto most = std::ranges::max_element(
        result_.groups, {}, [&](const auto& group) { return bytes_per_s(group); });
    auto& problem = diagnostics_.error(
        "E0426", telemetry_.span,
        fmt::format("telemetry needs {:.0f} bytes/s at its slowest, and may take {:.0f} of a line "
                    "of {} baud",
                    std::ceil(load()), std::floor(allowed()), telemetry_.baud));
    const auto of = ranges::find_if(telemetry_.channels, [&](const auto& channel) {
      return channel_of(channel) == most->channels.front().channel;
    });
    problem.notes.push_back({fmt::format("records with `{}` take most of it", of->port), of->span,
                             fmt::format("{} bytes at {:.4g} Hz", most->bytes, sent_hz(*most))});
    problem.help =
        "name fewer channels, a larger `share:`, or a faster `baud:` if the board has one; the "
        "slowest is a message a second";
    return false;
  }

  const Plan& plan_;
  const Telemetry& telemetry_;
  Diagnostics& diagnostics_;
  TelemetryPlan result_;
};

}  // namespace

std::uint64_t telemetry_frame_bytes(std::uint64_t payload) {
  constexpr std::uint64_t kCobsRun = 254;
  constexpr std::uint64_t kInside = 9;  // kind, number, CRC-32C
  const std::uint64_t bytes = payload + kInside;
  return bytes + bytes / kCobsRun + 3;
}

std::optional<TelemetryPlan> make_telemetry(const Plan& plan, Diagnostics& diagnostics) {
  return Teller(plan, diagnostics).run();
}

}  // namespace eagerx::gen
