#include "generator/graph/plan/pipelining.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "generator/graph/plan/split.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

/// Frames of a link that are in flight at most, and bytes of all of them: what a socket holds.
constexpr std::size_t kMostExchanges = 32;
constexpr std::size_t kMostBytesOnWay = std::size_t{1} << 16U;
/// Of the trace that waits.
constexpr std::size_t kLeastTraceBytes = std::size_t{1} << 12U;
constexpr std::size_t kMostTraceBytes = std::size_t{1} << 20U;
/// eagerx/link/pipeline.hpp: a record's header, and what its message is filled up to.
constexpr std::size_t kRecord = 32, kFilled = 16;

/// How long after it was sent a message is read, at the earliest.
struct Slack {
  Rational seconds;
  std::string why;  // who reads it then
};

/// The shortest time from a tick of one rate to a later one of another.
Rational shortest_gap(const Rational& a, const Rational& b) {
  return Rational(1) / lcm(a, b);
}

class ReadAhead {
 public:
  ReadAhead(const Plan& plan, Split& split)
      : plan_(plan), graph_(*plan.graph), part_of_(plan.graph->placement->part_of), split_(split) {}

  void run() {
    for (std::size_t part = 0; part < split_.links.size(); ++part) {
      split_.links[part].why_no_more = reason_against(part);
      split_.links[part].is_pipelined = split_.links[part].why_no_more.empty();
    }
    find_lags();
    for (std::size_t part = 0; part < split_.links.size(); ++part)
      if (split_.links[part].is_pipelined) look_at(part);
    if (ranges::none_of(split_.links, &PartLink::is_pipelined)) return;
    // The first message after a reset, and the one that is being sent, in addition to those in
    // flight.
    constexpr double kMoreSteps = 2.0;
    double steps = kMoreSteps, ticks = 1.0;
    for (std::size_t part = 0; part < split_.links.size(); ++part) {
      const PartLink& link = split_.links[part];
      steps = std::max(
          steps, kMoreSteps + static_cast<double>(link.depth) / std::max(link.exchanges, 1e-3));
      ticks = std::max(ticks, ticks_per_step(part));
    }
    constexpr double kMostTicks = 4096.0;
    split_.most_in_flight =
        static_cast<std::size_t>(std::clamp(std::ceil(steps * ticks), 8.0, kMostTicks));
    split_.trace_bytes = std::clamp(static_cast<std::size_t>(steps * record_bytes_per_step()),
                                    kLeastTraceBytes, kMostTraceBytes) /
                         kFilled * kFilled;
  }

 private:
  void look_at(std::size_t part) {
    PartLink& link = split_.links[part];
    const Slack slack = slack_of(part);
    const double per_s = link.exchanges * graph_.environment().rate_hz.to_double();
    const double ahead = std::floor(slack.seconds.to_double() * per_s + 1e-9);
    link.why_no_more = slack.why;
    if (ahead < 1.0) return;
    if (graph_.placement->parts[part].target->is_board() ||
        graph_.placement->parts[part].target->system.empty()) {
      link.why_no_more = "a board holds one request at a time";
      return;
    }
    const std::size_t payload = std::max(link.part_payload, link.hub_payload);
    const auto most = std::clamp<std::size_t>(kMostBytesOnWay / payload, 1, kMostExchanges);
    const auto wanted = 1 + static_cast<std::size_t>(std::min(ahead, 1e6));
    link.depth = std::min(most, wanted);
    if (link.depth == wanted) return;
    link.why_no_more = most == kMostExchanges
                           ? fmt::format("{} are the most of a link", most)
                           : fmt::format(
                                 "its frames have up to {} bytes, and {} are the most on "
                                 "their way",
                                 payload, kMostBytesOnWay);
  }

  /// Why the hub has to wait for each message of a part at once.
  [[nodiscard]] std::string reason_against(std::size_t part) const {
    const PartLink& link = split_.links[part];
    if (graph_.asynchronous) return "the graph has `sync: false`";
    if (plan_.schedule.masks.empty()) return "the rates are too far apart";
    if (link.several_frames) return "its messages take several frames";
    if (link.exchanges == 0.0) return "it sends nothing";
    return {};
  }

  /// The hub hands on a part's messages late where another part reads them late, so that the hub
  /// need not wait for it.
  void find_lags() {
    for (std::size_t part = 0; part < split_.links.size(); ++part) {
      std::vector<std::uint64_t>& lags = split_.links[part].lags;
      lags.resize(graph_.nodes.size());
      // Programs in other languages take a message where it is sent.
      if (!graph_.placement->parts[part].target->language.empty()) continue;
      for (std::size_t n = 0; n < lags.size(); ++n) {
        const std::size_t owner = part_of_[n];
        if (owner != part && owner != Placement::kHub && split_.links[owner].is_pipelined)
          lags[n] = lag_of(n, part);
      }
    }
  }
  /// Ticks of `source` that all its readers in `part` wait for a message.
  [[nodiscard]] std::uint64_t lag_of(std::size_t source, std::size_t part) const {
    std::uint64_t least = UINT64_MAX;
    for (std::size_t n = 0; n < graph_.nodes.size(); ++n) {
      if (part_of_[n] != part) continue;
      for (const Input& input : graph_.nodes[n].inputs) {
        if (input.source_node != source) continue;
        const Rational ticks = least_delay(input) * graph_.nodes[source].rate_hz;
        // The hub hands it on from its ring.
        const Ring& ring = plan_.rings[plan_.nodes[source].rings[input.source_output]];
        const auto late = input.skip ? 0 : static_cast<std::uint64_t>(ticks.floor());
        least = std::min({least, late, ring.capacity - 1});
      }
    }
    return least == UINT64_MAX ? 0 : least;
  }
  /// One that a reset may change may be none.
  static Rational least_delay(const Input& input) {
    const bool changes = input.max_delay_s || input.random_delay || input.entity_sets_delay;
    return changes ? Rational() : input.delay_s;
  }

  /// Of all that a part sends.
  [[nodiscard]] Slack slack_of(std::size_t part) const {
    constexpr std::int64_t kNever_s = 1'000'000;
    Slack least{Rational(kNever_s), ""};
    for (std::size_t n = 0; n < graph_.nodes.size(); ++n) {
      if (part_of_[n] == part) continue;
      for (const Input& input : graph_.nodes[n].inputs) {
        if (part_of_[input.source_node] != part) continue;
        const Slack slack = slack_of(n, input);
        if (slack.seconds < least.seconds) least = slack;
      }
    }
    return least;
  }
  [[nodiscard]] Slack slack_of(std::size_t n, const Input& input) const {
    const bool changes = input.max_delay_s || input.random_delay || input.entity_sets_delay;
    const std::string delay = changes ? "a delay that changes"
                              : input.delay_s == Rational()
                                  ? "no `delay`"
                                  : "`delay: " + input.delay_s.to_string() + "`";
    const Rational& sent_hz = graph_.nodes[input.source_node].rate_hz;
    if (part_of_[n] != Placement::kHub) {
      const PlacedPart& part = graph_.placement->parts[part_of_[n]];
      if (!part.target->language.empty())
        return {Rational(), fmt::format("part `{}`, in another language, takes it where it is sent",
                                        part.name)};
      const std::uint64_t lag = split_.links[part_of_[n]].lags[input.source_node];
      return {Rational(static_cast<std::int64_t>(lag)) / sent_hz,
              fmt::format("part `{}` reads it with {}", part.name, delay)};
    }
    Rational seconds = least_delay(input);
    if (input.skip) seconds = seconds + shortest_gap(sent_hz, graph_.nodes[n].rate_hz);
    return {seconds, fmt::format("`{}` reads it with {}", input.written, delay)};
  }

  [[nodiscard]] double ticks_per_step(std::size_t part) const {
    double ticks = 0.0;
    for (std::size_t n = 0; n < graph_.nodes.size(); ++n)
      if (part_of_[n] == part) ticks += rate_in_steps(n);
    return ticks;
  }
  [[nodiscard]] double record_bytes_per_step() const {
    double bytes = 0.0;
    for (const Channel& channel : plan_.channels) {
      const Output& output = graph_.nodes[channel.node].outputs[channel.output];
      const std::uint64_t filled = (bytes_of(output.space) + kFilled - 1) / kFilled * kFilled;
      bytes += static_cast<double>(kRecord + filled) * std::ceil(rate_in_steps(channel.node));
    }
    return bytes;
  }
  [[nodiscard]] double rate_in_steps(std::size_t n) const {
    return (graph_.nodes[n].rate_hz / graph_.environment().rate_hz).to_double();
  }

  const Plan& plan_;
  const Graph& graph_;
  const std::vector<std::size_t>& part_of_;
  Split& split_;
};

}  // namespace

void plan_pipelining(const Plan& plan, Split& split) {
  ReadAhead(plan, split).run();
}

}  // namespace eagerx::gen
