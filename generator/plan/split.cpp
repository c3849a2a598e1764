#include "generator/plan/split.hpp"

#include <algorithm>

namespace eagerx::gen {
namespace {

// Longer ones gain nothing: eleven bytes of a frame are 1 % of it.
constexpr std::size_t kLargestPayload = 1024;
constexpr std::size_t kGreeting = 16;  // eagerx/link/frame.hpp
constexpr std::size_t kCommand = 2;    // eagerx/link/stream.hpp
constexpr std::size_t kReset = 18;

/// Follows the messages over the link through a hyperperiod, as the two programs do.
class Line {
 public:
  Line(const Plan& plan, const Split& split) : plan_(plan) {
    const Graph& graph = *plan.graph;
    bytes_.resize(graph.nodes.size());
    for (std::size_t c = 0; c < plan.channels.size(); ++c) {
      const Channel& channel = plan.channels[c];
      const std::size_t bytes = bytes_of(graph.nodes[channel.node].outputs[channel.output].space);
      if (split.to_board[c] || split.to_host[c]) bytes_[channel.node] += bytes;
    }
    // Whether a reset node has reached its targets.
    for (const auto& node : graph.nodes) done_ += node.reset_targets.size();
  }

  /// One slot; `mask` is what is due in it, `next` in the one after it.
  void slot(std::uint64_t mask, std::uint64_t next) {
    if (due(Graph::kEnvironment, mask)) {
      to_board(kCommand);
      node(Graph::kEnvironment, mask);
      ++steps_;
    }
    for (const std::size_t n : plan_.after) node(n, mask);
    for (const std::size_t n : plan_.before) node(n, next);
  }
  void start_counting() { exchanges_ = steps_ = board_ = host_ = 0; }

  /// `split` with what a link needs for it.
  [[nodiscard]] Split measured(Split split) const {
    split.board_payload =
        std::clamp(std::max(most_board_, run_board_) + kReset, kGreeting, kLargestPayload);
    split.host_payload =
        std::clamp(std::max(most_host_, run_host_) + done_, kGreeting, kLargestPayload);
    if (steps_ == 0) return split;
    const auto per_step = [&](std::size_t count) {
      return static_cast<double>(count) / static_cast<double>(steps_);
    };
    split.exchanges = per_step(exchanges_);
    split.board_bytes = per_step(board_);
    split.host_bytes = per_step(host_);
    return split;
  }

 private:
  bool due(std::size_t n, std::uint64_t mask) const {
    return (mask >> plan_.nodes[n].rate & 1U) != 0;
  }
  void node(std::size_t n, std::uint64_t mask) {
    if (!due(n, mask) || bytes_[n] == 0) return;
    plan_.graph->placement->on_board[n] ? to_host(bytes_[n]) : to_board(bytes_[n]);
  }
  void to_board(std::size_t bytes) {
    most_host_ = std::max(most_host_, run_host_);
    run_host_ = 0;
    run_board_ += bytes;
    board_ += bytes;
  }
  void to_host(std::size_t bytes) {
    // The host asks for the first message after some of its own.
    if (run_host_ == 0) ++exchanges_;
    most_board_ = std::max(most_board_, run_board_);
    run_board_ = 0;
    run_host_ += bytes;
    host_ += bytes;
  }

  const Plan& plan_;
  std::vector<std::size_t> bytes_;  // of what a node sends over the link at a tick
  std::size_t done_ = 0;
  std::size_t run_board_ = 0, run_host_ = 0, most_board_ = 0, most_host_ = 0;
  std::size_t exchanges_ = 0, steps_ = 0, board_ = 0, host_ = 0;
};

Split find_messages(const Plan& plan) {
  Split split;
  const Graph& graph = *plan.graph;
  const std::vector<bool>& on_board = graph.placement->on_board;
  split.to_board.resize(plan.channels.size());
  split.to_host.resize(plan.channels.size());
  for (std::size_t c = 0; c < plan.channels.size(); ++c) {
    const Channel& channel = plan.channels[c];
    // The host's trace has every message.
    split.to_host[c] = on_board[channel.node];
    split.to_board[c] =
        !on_board[channel.node] && crosses(graph, on_board, channel.node, channel.output);
  }
  return split;
}

}  // namespace

Split make_split(const Plan& plan) {
  Split split = find_messages(plan);
  Line line(plan, split);
  std::vector<std::uint64_t> masks = plan.schedule.masks;
  // A hyperperiod too long for a table: as if all rates were due at once, which is the most.
  if (masks.empty()) masks = {~std::uint64_t{0}};
  constexpr int kPasses = 2;  // the first one leads in
  for (int pass = 0; pass < kPasses; ++pass) {
    line.start_counting();
    for (std::size_t i = 0; i < masks.size(); ++i)
      line.slot(masks[i], masks[(i + 1) % masks.size()]);
  }
  split = line.measured(std::move(split));
  if (plan.schedule.masks.empty()) split.exchanges = split.board_bytes = split.host_bytes = 0.0;
  return split;
}

}  // namespace eagerx::gen
