#include "generator/analysis/bound/walk.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace eagerx::gen::bound {
namespace {

bool is_on_every_turn(const Flow& flow, const Loop& loop, BlockIndex block) {
  return std::ranges::all_of(loop.latches,
                             [&](BlockIndex latch) { return flow.dominates(block, latch); });
}

/// When a branch is taken.
Condition condition_of(const Instruction& branch) {
  if (!branch.name.starts_with("cb")) return branch.condition;
  return branch.name == "cbz" ? Condition::eq : Condition::ne;
}

/// Brings a state to a place that another one may have come to.
template <class Key>
void add(std::map<Key, State>& states, const Key& to, State&& state, Address at) {
  const auto [found, is_new] = states.try_emplace(to, std::move(state));
  if (!is_new) join(found->second, state, at);
}

}  // namespace

void Walk::function(const State& entry) {
  entry_ = entry;
  result_.flow = &flow_;
  result_.reached.assign(flow_.blocks.size(), false);
  result_.most_turns.assign(flow_.loops.size(), 0);
  for (const auto& [from, to] : flow_.entered_elsewhere)
    result_.obstacles.push_back({Reason::several_entries, address(to)});
  pass(kNone, entry, true);
  for (BlockIndex b = 0; b < flow_.blocks.size(); ++b) {
    const Block& block = flow_.blocks[b];
    if (!result_.reached[b]) continue;
    if (block.lost) result_.obstacles.push_back({Reason::lost, block.code.back()->at});
    result_.returns |= block.returns || block.lost;
  }
}

Walk::Pass Walk::pass(LoopIndex loop_index, const State& header, bool record) {
  Pass result;
  std::map<BlockIndex, State> open;
  open.emplace(loop_index == kNone ? 0 : flow_.loops[loop_index].header, header);
  for (const BlockIndex b : flow_.order_in(loop_index)) {
    const auto found = open.extract(b);
    if (found.empty()) continue;
    State& state = found.mapped();
    const LoopIndex inner = flow_.child(loop_index, b);
    if (inner == kNone) {
      block(loop_index, b, std::move(state), record, result, open);
    } else {
      for (auto& [edge, out] : loop(inner, state, record))
        deliver(loop_index, edge, std::move(out), record, result, open);
    }
  }
  return result;
}

void Walk::block(LoopIndex loop_index, BlockIndex b, State&& state, bool record, Pass& to,
                 std::map<BlockIndex, State>& open) {
  const Block& here = flow_.blocks[b];
  if (record) result_.reached[b] = true;
  for (const Instruction* instruction : here.code) {
    const Turn turn = instruction->turn;
    if (record && turn == Turn::call_pointer)
      result_.obstacles.push_back({Reason::pointer_call, instruction->at});
    if (record && turn == Turn::call) {
      const Address callee = instruction->target;
      if (analysis_.active_.contains(callee))
        result_.obstacles.push_back({Reason::recursion, instruction->at});
      else
        result_.calls[instruction->at] = analysis_.analyse(callee, entry_state(callee, &state));
    }
    apply(image_, *instruction, state, analysis_.sums_);
  }
  const auto branch = branch_of(here, state);
  if (branch) to.tests[b] = branch->comparison;
  const auto is_taken = branch ? branch->is_taken : std::nullopt;
  for (std::size_t i = 0; i < here.next.size(); ++i) {
    if (!flow_.is_in(here.next[i], loop_index)) (is_taken ? to.decides : to.hesitates) = true;
    if (is_taken && *is_taken != (i == 1)) continue;
    State after = i + 1 < here.next.size() ? state : std::move(state);
    if (branch)
      after.learn(i == 1 ? branch->condition : opposite(branch->condition), branch->comparison);
    deliver(loop_index, {b, here.next[i]}, std::move(after), record, to, open);
  }
}

/// The branch at the end of a block with two ways on; nullopt: what it compares is not known.
std::optional<Walk::Branch> Walk::branch_of(const Block& block, const State& state) {
  if (block.code.empty()) return std::nullopt;
  const Instruction& last = *block.code.back();
  if (last.turn != Turn::branch || block.next.size() != 2) return std::nullopt;
  Branch branch{condition_of(last), {}, std::nullopt};
  if (last.name.starts_with("cb")) {
    const auto tested = register_of(last.operands.front());
    if (!tested) return std::nullopt;
    branch.comparison = {state.registers[*tested], Value::of(0), false};
  } else {
    if (!state.comparison) return std::nullopt;
    branch.comparison = *state.comparison;
  }
  Comparison known = branch.comparison;
  if (!state.relate(known.left, known.right)) known = branch.comparison;
  branch.is_taken = holds(branch.condition, known);
  return branch;
}

void Walk::deliver(LoopIndex loop_index, Edge edge, State&& state, bool record, Pass& to,
                   std::map<BlockIndex, State>& open) {
  if (record) result_.possible.insert(edge);
  const BlockIndex target = edge.second;
  if (loop_index != kNone && target == flow_.loops[loop_index].header) {
    auto& [escaped, arguments] = escapes_.try_emplace(loop_index, INT64_MAX, false).first->second;
    if (state.escaped < escaped || (state.arguments_escaped && !arguments)) ++escape_changes_;
    escaped = std::min(escaped, state.escaped);
    arguments |= state.arguments_escaped;
    if (to.latch)
      join(*to.latch, state, address(target));
    else
      to.latch = std::move(state);
  } else if (flow_.is_in(target, loop_index)) {
    add(open, target, std::move(state), address(target));
  } else {
    add(to.exits, edge, std::move(state), address(target));
  }
}

std::optional<Progress> Walk::progress(LoopIndex l, const State& in, const Changes& changes,
                                       const Value& value) const {
  const Address at = address(flow_.loops[l].header);
  for (const auto& [where, step] : changes.steps) {
    if (value.base != base_of(Origin::header, at, where)) continue;
    const auto start = sum(*in.find(where), {0, value.low, value.high}, 1);
    return start ? std::optional(Progress{*start, step}) : std::nullopt;
  }
  for (const Location& where : changes.fixed) {
    if (value.base != base_of(Origin::header, at, where)) continue;
    const auto start = sum(*in.find(where), {0, value.low, value.high}, 1);
    return start ? std::optional(Progress{*start, Value::of(0)}) : std::nullopt;
  }
  return Progress{value, Value::of(0)};
}

/// Whether no turn is possible without one of these tests.
bool Walk::separates(LoopIndex l, const std::set<BlockIndex>& tests) const {
  const Loop& loop = flow_.loops[l];
  std::vector<BlockIndex> open = {loop.header};
  std::set<BlockIndex> seen;
  while (!open.empty()) {
    const BlockIndex b = open.back();
    open.pop_back();
    if (tests.contains(b) || !seen.insert(b).second) continue;
    for (const BlockIndex next : flow_.blocks[b].next) {
      if (next == loop.header) return false;
      if (loop.has[next]) open.push_back(next);
    }
  }
  return true;
}

/// A turn after the most that a test allows would leave the loop there. So the first tests, by what
/// they allow, of which every turn makes one.
std::optional<Turns> Walk::turns(LoopIndex l, const State& in, const Pass& pass,
                                 const Changes& changes) {
  std::vector<std::pair<Turns, BlockIndex>> tests;
  const auto progress_of = [&](const Value& value) -> std::optional<Progress> {
    const auto found = progress(l, in, changes, value);
    // What the loop itself makes is another number every turn.
    if (!found || (found->start.base == value.base && is_made_in(l, value.base)))
      return std::nullopt;
    return found;
  };
  for (const auto& [edge, state] : pass.exits) {
    const auto test = pass.tests.find(edge.first);
    const Block& block = flow_.blocks[edge.first];
    if (test == pass.tests.end() || block.loop != l) continue;
    const Condition condition = condition_of(*block.code.back());
    const bool leaves_when_taken = edge.second == block.next[1];
    const auto found = turns_of({test->second, leaves_when_taken ? opposite(condition) : condition},
                                progress_of, in);
    if (found) tests.emplace_back(*found, edge.first);
  }
  std::ranges::sort(tests, {}, [](const auto& test) { return test.first.most; });
  std::set<BlockIndex> passed;
  for (const auto& [turns, block] : tests) {
    passed.insert(block);
    if (!separates(l, passed)) continue;
    return Turns{turns.most, turns.is_exact && pass.exits.size() == 1};
  }
  return std::nullopt;
}

/// The bound that the source states at a place that every turn passes. Copies of it are those of
/// another loop that was unrolled, perhaps, and say nothing.
std::optional<std::uint64_t> Walk::noted(LoopIndex l) const {
  const Loop& loop = flow_.loops[l];
  std::optional<std::uint64_t> most;
  for (BlockIndex b = 0; b < flow_.blocks.size(); ++b) {
    if (flow_.blocks[b].loop != l) continue;
    for (const Instruction* instruction : flow_.blocks[b].code) {
      const auto note = image_.notes().find(instruction->at);
      if (note == image_.notes().end()) continue;
      if (most || !is_on_every_turn(flow_, loop, b)) return std::nullopt;
      most = note->second.waits ? 0 : note->second.most;
    }
  }
  if (!most) return most;
  return *most + 1;
}

/// Known bounds of the loops of libraries.
std::optional<std::uint64_t> Walk::of_library(LoopIndex l) const {
  constexpr std::size_t kBytes = 2;  // r2: memset, memcpy and memmove take a number of bytes
  const auto found = analysis_.library_.find(address(flow_.loops[l].header));
  if (found == analysis_.library_.end()) return std::nullopt;
  const LibraryLoop& loop = found->second;
  if (loop.bytes_a_turn == 0) return loop.most;
  const Value& bytes = entry_.registers[kBytes];
  if (flow_.entry != loop.function || bytes.base != 0 || bytes.low < 0) return std::nullopt;
  return loop.most + static_cast<std::uint64_t>(bytes.high) / loop.bytes_a_turn;
}

/// Turn by turn with what is known of each, while that is not the same again: flags, shifts. Given
/// up where the first turns decide no test of the loop and their number is not known.
Walk::Enumerated Walk::one_by_one(LoopIndex l, const State& in, std::optional<Turns> known) {
  constexpr std::uint64_t kMostTurns = 64, kUndecided = 2;
  if (depth_ > 0) return {known, {}};  // not in each turn of another one
  if (known && known->most > kMostTurns) return {known, {}};
  ++depth_;
  std::optional<State> header = in;
  FlatMap<Location, Value> ranges;
  const std::uint64_t most = known ? known->most : kMostTurns;
  std::uint64_t turns = 0;
  bool decides = false, hesitates = false;
  Counts outside = std::exchange(inner_, {});
  while (header && turns < most) {
    widen(ranges, *header, turns == 0);
    // What a turn before made is another number than what this one makes.
    State open = open_header(l, *header, {});
    for (const Location& where : header->locations()) {
      if (!is_made_in(l, header->find(where)->base)) open.set(where, *header->find(where));
    }
    Pass turn = pass(l, open, false);
    decides |= turn.decides;
    ++turns;
    hesitates |= turn.hesitates;
    const bool is_lost = turns >= kUndecided && hesitates && !decides;
    if (!known && turn.latch && (is_same(*turn.latch, *header) || is_lost)) break;
    header = std::move(turn.latch);
  }
  --depth_;
  if (known || !header) {
    for (const auto& [loop, count] : inner_) outside[loop] = count;
  }
  inner_ = std::move(outside);
  if (known) return {known, std::move(ranges)};
  if (header) return {};
  return {Turns{turns, false}, std::move(ranges)};
}

/// A pass with less than what is known of the header: what it finds of inner loops does not count.
Walk::Pass Walk::trial(LoopIndex l, const State& header) {
  ++trials_;
  Pass result = pass(l, header, false);
  --trials_;
  return result;
}

bool Walk::FirstTrial::is_of(const State& other) const {
  return header.registers[kSp] == other.registers[kSp] && header.stack == other.stack &&
         header.escaped == other.escaped && header.arguments_escaped == other.arguments_escaped;
}

/// A trial with all values open but the stack pointer. It is the same each time the loop is entered
/// with the same words of the stack.
Walk::FirstTrial Walk::first_trial(LoopIndex l, const State& in) {
  const Locations kept(Location{false, kSp});
  FirstTrial result;
  result.header = open_header(l, in, kept);
  result.is_in_turns = depth_ > 0;
  result.escapes = escape_changes_;
  for (const FirstTrial& known : first_trials_[l]) {
    if (known.is_in_turns != result.is_in_turns || known.escapes != result.escapes ||
        !known.is_of(result.header))
      continue;
    unbounded_ += known.unbounded;
    return known;
  }
  const unsigned unbounded = unbounded_;
  const Pass pass = trial(l, result.header);
  result.turns_back = pass.latch.has_value();
  if (pass.latch) result.found = changes(l, in, result.header, *pass.latch, kept);
  result.unbounded = unbounded_ - unbounded;
  // Limits are of numbers that this header does not have, unless its stack pointer is one.
  if (escape_changes_ == result.escapes && in.registers[kSp].base == kStack)
    first_trials_[l].push_back(result);
  return result;
}

std::map<Edge, State> Walk::loop(LoopIndex l, const State& in, bool record) {
  // First with all values open, then with those that stay and those that keep their distance.
  Ties ties;
  Enumerated turned;
  std::optional<Turns>& count = turned.count;
  const unsigned unbounded = unbounded_;
  FirstTrial first = first_trial(l, in);
  Changes& found = first.found;
  bool leaves_at_one = false;
  if (first.turns_back) {
    ties = likely_ties(in, found.fixed);
    State header = open_header(l, in, found.fixed);
    tie(l, in, ties, header);
    Pass second = trial(l, header);
    for (bool again = true; second.latch && !hold(ties, in, *second.latch); again = false) {
      ties = again ? kept_ties(ties, in, *second.latch) : Ties();
      header = open_header(l, in, found.fixed);
      tie(l, in, ties, header);
      second = trial(l, header);
    }
    if (second.latch) {
      found = changes(l, in, header, *second.latch, found.fixed);
      ties.erase_if([&](const auto& tie) {
        return found.fixed.contains(tie.first) || found.fixed.contains(tie.second);
      });
      count = turns(l, in, second, found);
      leaves_at_one = second.exits.size() == 1;
    } else {
      count = Turns{1, true};
    }
  } else {
    count = Turns{1, true};  // it never goes back
    for (const Location& where : in.locations()) found.fixed.insert(where);
  }
  if (const auto known = of_library(l); known && !count) count = Turns{*known, false};
  const bool inner_depends = record && count && unbounded_ > unbounded;
  if ((!count && !noted(l)) || inner_depends) turned = one_by_one(l, in, count);
  if (const auto note = noted(l); note && (!count || *note < count->most))
    turned = {Turns{*note, false}, {}};
  count_inner(l, record, count);
  if (record) {
    result_.most_turns[l] = count ? std::optional(count->most) : std::nullopt;
    if (!count) result_.obstacles.push_back({Reason::loop, address(flow_.loops[l].header)});
  }
  const auto last = [&] {
    return pass(l, running_header(l, in, found, ties, turned, true), false).exits;
  };
  // Where nothing is recorded, the last turn is all that matters.
  const bool is_exact = count && count->is_exact;
  const bool is_counting = depth_ > 0 && trials_ == 0;
  if (!record && !is_counting && is_exact && leaves_at_one) return last();
  auto exits = pass(l, running_header(l, in, found, ties, turned, false), record).exits;
  return is_exact && exits.size() == 1 ? last() : std::move(exits);
}

/// Within a loop that is gone through turn by turn, the most turns of an inner loop in each of
/// them; later, in the record of it, this number.
void Walk::count_inner(LoopIndex l, bool record, std::optional<Turns>& count) {
  if (!count) ++unbounded_;
  const auto most = count ? std::optional(count->most) : std::nullopt;
  if (depth_ > 0 && trials_ == 0) {
    const auto [known, is_new] = inner_.emplace(l, most);
    if (!is_new)
      known->second = known->second && most ? std::max(known->second, most) : std::nullopt;
  }
  const auto known = inner_.find(l);
  if (record && !count && known != inner_.end() && known->second)
    count = Turns{*known->second, false};
}

}  // namespace eagerx::gen::bound
