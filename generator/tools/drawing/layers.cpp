#include "generator/tools/drawing/layers.hpp"

#include <algorithm>
#include <cstdint>
#include <deque>

namespace eagerx::gen {
namespace {

/// Boxes in an order that few wires run against: Eades, Lin, Smyth, "A fast and effective heuristic
/// for the feedback arc set problem" (1993).
class Sequence {
 public:
  explicit Sequence(const Drawing& drawing)
      : ins_(drawing.boxes.size()),
        outs_(ins_.size()),
        readers_(ins_.size()),
        senders_(ins_.size()) {
    for (const Wire& wire : drawing.wires) {
      if (wire.from == wire.to) continue;
      ++outs_[wire.from];
      ++ins_[wire.to];
      readers_[wire.from].push_back(wire.to);
      senders_[wire.to].push_back(wire.from);
    }
  }

  /// The place of each box in the order.
  std::vector<std::size_t> places() {
    const std::size_t n = ins_.size();
    gone_.assign(n, false);
    for (std::size_t box = 0; box < n; ++box) note(box);
    while (left_.size() + right_.size() < n) {
      if (take(sinks_, right_, outs_) || take(sources_, left_, ins_)) continue;
      remove(most_outgoing(), left_);
    }
    std::vector<std::size_t> result(n);
    for (std::size_t i = 0; i < left_.size(); ++i) result[left_[i]] = i;
    for (std::size_t i = 0; i < right_.size(); ++i) result[right_[i]] = n - 1 - i;
    return result;
  }

 private:
  void note(std::size_t box) {
    if (outs_[box] == 0) sinks_.push_back(box);
    if (ins_[box] == 0) sources_.push_back(box);
  }

  bool take(std::deque<std::size_t>& queue, std::vector<std::size_t>& side,
            const std::vector<std::int64_t>& degree) {
    while (!queue.empty()) {
      const std::size_t box = queue.front();
      queue.pop_front();
      if (gone_[box] || degree[box] != 0) continue;
      remove(box, side);
      return true;
    }
    return false;
  }

  void remove(std::size_t box, std::vector<std::size_t>& side) {
    gone_[box] = true;
    side.push_back(box);
    for (const std::size_t reader : readers_[box]) --ins_[reader];
    for (const std::size_t sender : senders_[box]) --outs_[sender];
    for (const std::size_t reader : readers_[box]) note_if_left(reader);
    for (const std::size_t sender : senders_[box]) note_if_left(sender);
  }

  void note_if_left(std::size_t box) {
    if (!gone_[box]) note(box);
  }

  std::size_t most_outgoing() const {
    std::size_t best = ins_.size();
    for (std::size_t box = 0; box < ins_.size(); ++box) {
      if (gone_[box]) continue;
      if (best == ins_.size() || outs_[box] - ins_[box] > outs_[best] - ins_[best]) best = box;
    }
    return best;
  }

  std::vector<std::int64_t> ins_, outs_;
  std::vector<std::vector<std::size_t>> readers_, senders_;
  std::vector<bool> gone_;
  std::deque<std::size_t> sinks_, sources_;
  std::vector<std::size_t> left_, right_;
};

}  // namespace

Layers layers_of(const Drawing& drawing) {
  const std::size_t n = drawing.boxes.size();
  Layers result{std::vector<std::size_t>(n, 0), std::vector<bool>(drawing.wires.size(), false), 1};
  const std::vector<std::size_t> place = Sequence(drawing).places();
  std::vector<std::size_t> order(n);
  for (std::size_t box = 0; box < n; ++box) order[place[box]] = box;
  std::vector<std::vector<std::size_t>> readers(n);
  std::vector<bool> has_sender(n, false);
  for (std::size_t w = 0; w < drawing.wires.size(); ++w) {
    const Wire& wire = drawing.wires[w];
    result.backwards[w] = place[wire.from] >= place[wire.to];
    if (result.backwards[w]) continue;
    readers[wire.from].push_back(wire.to);
    has_sender[wire.to] = true;
  }
  // The contents of a composite are between its two ends.
  const bool within = drawing.boxes.front().kind == BoxKind::entry;
  if (within) std::fill(result.layer.begin() + 1, result.layer.end(), 1);
  for (const std::size_t box : order) {
    for (const std::size_t reader : readers[box])
      result.layer[reader] = std::max(result.layer[reader], result.layer[box] + 1);
    result.count = std::max(result.count, result.layer[box] + 1);
  }
  if (within) {
    const auto is_last = [&](std::size_t layer) { return layer == result.count - 1; };
    const auto shared =
        std::ranges::count_if(result.layer.begin() + 2, result.layer.end(), is_last);
    result.count += shared > 0 ? 1 : 0;
    result.layer[1] = result.count - 1;
  }
  // Boxes without a sender are next to their readers, and the observations at the right edge.
  for (std::size_t box = 0; box < n; ++box) {
    if (drawing.boxes[box].kind == BoxKind::observations) result.layer[box] = result.count - 1;
    if (has_sender[box] || readers[box].empty() || drawing.boxes[box].kind == BoxKind::actions ||
        drawing.boxes[box].kind == BoxKind::entry)
      continue;
    std::size_t nearest = result.count;
    for (const std::size_t reader : readers[box]) nearest = std::min(nearest, result.layer[reader]);
    result.layer[box] = nearest - 1;
  }
  return result;
}

}  // namespace eagerx::gen
