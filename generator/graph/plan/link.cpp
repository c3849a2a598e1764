#include "generator/graph/plan/link.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <set>
#include <tuple>

#include "generator/support/diagnostics/join.hpp"

namespace eagerx::gen {
namespace {

bool is_behind_engine(const GraphNode& node) {
  return node.role == NodeRole::engine || node.role == NodeRole::engine_node;
}

std::string name_of(const GraphNode& node, const Output& output) {
  if (!output.sensors.empty()) return fmt::format("{}", join(output.sensors, ", "));
  return (node.role == NodeRole::environment ? "actions" : node.name) + "." + output.name;
}

class LinkReader {
 public:
  explicit LinkReader(const Plan& plan) : plan_(plan) {}

  Link run() {
    for (std::size_t n = 0; n < plan_.graph->nodes.size(); ++n) read(n);
    std::ranges::sort(link_.messages, {}, [](const LinkMessage& message) {
      return std::tie(message.to_engine, message.name);
    });
    link_.sensors = load(false);
    link_.actuators = load(true);
    return std::move(link_);
  }

 private:
  void read(std::size_t reader) {
    const auto& nodes = plan_.graph->nodes;
    if (nodes[reader].drawn) return;  // no part of a controller
    for (const Input& input : nodes[reader].inputs) {
      const GraphNode& source = nodes[input.source_node];
      if (is_behind_engine(source) == is_behind_engine(nodes[reader])) continue;
      if (!seen_.insert({input.source_node, input.source_output}).second) continue;
      const Output& output = source.outputs[input.source_output];
      const bool to_engine = !is_behind_engine(source);
      link_.messages.push_back({name_of(source, output), to_engine, source.rate_hz,
                                bytes_of(output.space), output.span});
      rates_[to_engine ? 1 : 0] |= std::uint64_t{1} << plan_.nodes[input.source_node].rate;
    }
  }

  LinkLoad load(bool to_engine) const {
    LinkLoad load;
    for (const auto& message : link_.messages) {
      if (message.to_engine != to_engine) continue;
      load.bytes_per_s = load.bytes_per_s + message.bytes_per_s();
      load.largest_frame += message.bytes;  // at an episode's start everything is due
    }
    load.frames_per_s = frames_per_s(rates_[to_engine ? 1 : 0]);
    load.baud =
        Rational(kBitsOfByte) * (load.bytes_per_s + Rational(kFrameBytes) * load.frames_per_s);
    return load;
  }

  /// Instants at which one of these rates is due; without a table their sum, which is no less.
  Rational frames_per_s(std::uint64_t rates) const {
    Rational sum;
    std::uint64_t hyperperiod = 1;
    for (std::size_t i = 0; i < plan_.rates.size(); ++i) {
      if ((rates >> i & 1U) != 0) sum = sum + plan_.rates[i].rate_hz;
      hyperperiod = plan_.schedule.masks.empty() ? 1 : std::lcm(hyperperiod, plan_.rates[i].period);
    }
    if (plan_.schedule.masks.empty()) return sum;
    const auto due = std::ranges::count_if(plan_.schedule.masks,
                                           [&](std::uint64_t mask) { return (mask & rates) != 0; });
    const RateClass& fastest = plan_.rates.front();
    const Rational hyperperiods_per_s = fastest.rate_hz *
                                        Rational(static_cast<std::int64_t>(fastest.period)) /
                                        Rational(static_cast<std::int64_t>(hyperperiod));
    return Rational(due) * hyperperiods_per_s;
  }

  const Plan& plan_;
  Link link_;
  std::set<std::pair<std::size_t, std::size_t>> seen_;
  std::uint64_t rates_[2] = {0, 0};
};

}  // namespace

Link link_of(const Plan& plan) {
  return LinkReader(plan).run();
}

}  // namespace eagerx::gen
