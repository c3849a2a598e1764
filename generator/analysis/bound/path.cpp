#include "generator/analysis/bound/path.hpp"

#include <algorithm>

namespace eagerx::gen::bound {

Weight Weight::all(const Cost& cost) {
  Weight weight;
  weight.cost = &cost;
  return weight;
}

std::uint64_t LongestPath::of(const Analysed& function) {
  first_ = &function;
  return length(function);
}

std::uint64_t LongestPath::length(const Analysed& function) {
  const auto known = known_.find(&function);
  if (known != known_.end()) return known->second;
  const Part whole = part(function, kNone);
  if (whole.weighs) {
    for (const Obstacle& obstacle : function.obstacles) {
      if (obstacle.reason != Reason::loop) obstacles_.insert(obstacle);
    }
  }
  return known_[&function] = whole.returns;
}

std::uint64_t LongestPath::call(const Analysed& function, const Instruction& instruction) {
  const auto callee = function.calls.find(instruction.at);
  // What never returns is on no path to a return.
  if (callee == function.calls.end() || !callee->second->returns) return 0;
  const auto share =
      weight_.callee ? weight_.callee(instruction, &function == first_) : Weight::Callee::whole;
  if (share == Weight::Callee::nothing) return 0;
  if (share == Weight::Callee::by_weight) {
    const bool may_count = !weight_.may_count || weight_.may_count(*callee->second);
    return may_count ? length(*callee->second) : 0;
  }
  auto known = whole_.find(callee->second);
  if (known == whole_.end()) {
    LongestPath whole(Weight::all(*weight_.cost), whole_);
    const std::uint64_t most = whole.of(*callee->second);
    known = whole_.emplace(callee->second, Length{most, whole.obstacles()}).first;
  }
  const Length& length = known->second;
  obstacles_.insert(length.obstacles.begin(), length.obstacles.end());
  return length.most;
}

std::uint64_t LongestPath::block(const Analysed& function, BlockIndex b) {
  std::uint64_t sum = 0;
  const Instruction* before = nullptr;
  for (const Instruction* instruction : function.flow->blocks[b].code) {
    if (counts(function, *instruction)) sum += weight_.cost->of(*instruction, before);
    before = instruction;
    if (instruction->turn != Turn::call) continue;
    sum += call(function, *instruction);
    before = nullptr;  // the callee was fetched meanwhile
  }
  return sum;
}

/// What the jump at a block's end takes on the way to `next`.
std::uint64_t LongestPath::jump(const Analysed& function, BlockIndex b, BlockIndex next) const {
  const Block& from = function.flow->blocks[b];
  const Block& to = function.flow->blocks[next];
  if (from.code.empty() || to.code.empty()) return 0;
  const Instruction& last = *from.code.back();
  const Address target = to.code.front()->at;
  const bool falls = target == last.next && last.target != target;
  if (falls || !counts(function, last)) return 0;
  return weight_.cost->taken(last);
}

void LongestPath::leave(const Analysed& function, LoopIndex loop, Edge edge, std::uint64_t length,
                        Part& part, std::map<BlockIndex, std::uint64_t>& open) {
  const Flow& flow = *function.flow;
  const auto longest = [&](std::uint64_t& to) { to = std::max(to, length); };
  if (loop != kNone && edge.second == flow.loops[loop].header)
    part.turn = std::max(part.turn.value_or(0), length);
  else if (flow.is_in(edge.second, loop))
    longest(open[edge.second]);
  else
    longest(part.leaves[edge]);
}

LongestPath::Part LongestPath::part(const Analysed& function, LoopIndex loop) {
  const Flow& flow = *function.flow;
  Part result;
  std::map<BlockIndex, std::uint64_t> open;
  open[loop == kNone ? 0 : flow.loops[loop].header] = 0;
  for (const BlockIndex b : flow.order_in(loop)) {
    const auto found = open.find(b);
    if (found == open.end() || !function.reached[b]) continue;
    const std::uint64_t before = found->second;
    if (const LoopIndex inner = flow.child(loop, b); inner != kNone) {
      if (flow.loops[inner].header != b) continue;
      const Part all = turned(function, inner);
      result.weighs |= all.weighs;
      result.returns = std::max(result.returns, before + all.returns);
      for (const auto& [edge, length] : all.leaves)
        leave(function, loop, edge, before + length, result, open);
      continue;
    }
    const std::uint64_t own = block(function, b);
    result.weighs |= own > 0;
    if (flow.blocks[b].returns) result.returns = std::max(result.returns, before + own);
    for (const BlockIndex next : flow.blocks[b].next) {
      if (function.possible.contains({b, next}))
        leave(function, loop, {b, next}, before + own + jump(function, b, next), result, open);
    }
  }
  return result;
}

/// A loop with all its turns.
LongestPath::Part LongestPath::turned(const Analysed& function, LoopIndex loop) {
  const BlockIndex header = function.flow->loops[loop].header;
  const Address at = function.flow->blocks[header].code.front()->at;
  if (weight_.never.contains(at)) return {};
  Part once = part(function, loop);
  if (!once.turn || !once.weighs) return once;
  if (&function == first_ && weight_.once.contains(loop)) {
    // A turn may end at the header: what is asked for is over then.
    for (auto& [edge, length] : once.leaves) length = std::max(length, *once.turn);
    once.returns = once.returns > 0 ? std::max(once.returns, *once.turn) : 0;
    return once;
  }
  const auto most = function.most_turns[loop];
  if (!most) {
    obstacles_.insert({Reason::loop, at});
    return once;
  }
  const std::uint64_t turns = (*most > 0 ? *most - 1 : 0) * *once.turn;
  if (once.returns > 0) once.returns += turns;
  for (auto& [edge, length] : once.leaves) length += turns;
  return once;
}

}  // namespace eagerx::gen::bound
